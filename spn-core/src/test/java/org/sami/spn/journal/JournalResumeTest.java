package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.Durability;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.MemoryJournal;
import org.sami.spn.protocol.Effect;

/** Crashes after every entry of a mission, resumes, and compares with the run that nothing interrupted. */
class JournalResumeTest {
    private static final JournalOptions OPTIONS = JournalOptions.DEFAULT.withSnapshotEvery(5);

    @TempDir
    Path folder;

    private final MemoryJournal whole = new MemoryJournal();
    private final Tour uninterrupted = Tour.fresh(whole).run();

    @Test
    void theMissionEndsAndHasEverythingInIt() {
        assertThat(uninterrupted.effects())
                .hasAtLeastOneElementOfType(Effect.DecisionOpened.class)
                .hasAtLeastOneElementOfType(Effect.Activated.class);
        assertThat(uninterrupted.effects().stream().filter(Effect.MissionEnded.class::isInstance))
                .as("three legs and the tour")
                .hasSizeGreaterThanOrEqualTo(2);
        assertThat(uninterrupted.effects()).noneMatch(Effect.Noted.class::isInstance);
        assertThat(whole.entries()).hasSizeGreaterThan(10);
    }

    @Test
    void aMissionThatCrashedAfterAnyEntryGoesOnAsIfNothingHadHappened() throws IOException {
        for (int crash = 0; crash <= whole.lastIndex(); crash++) {
            Path file = folder.resolve("crash-" + crash);
            CrashingJournal dying = new CrashingJournal(
                    SqliteJournal.create(folder.resolve("live-" + crash), Tour.HEADER, OPTIONS), crash, file);
            Set<Long> commanded = new LinkedHashSet<>(dying.runUntilCrash());

            try (SqliteJournal journal = SqliteJournal.open(file, OPTIONS)) {
                assertThat(journal.lastIndex()).isEqualTo(crash);
                assertThat(journal.recovery().damage()).isEmpty();
                Engine engine = Tour.engine();
                Tour resumed = new Tour(journal, journal.restore(engine), engine).run();

                assertThat(resumed.stateBytes()).as("crash after %d", crash).isEqualTo(uninterrupted.stateBytes());
                commanded.addAll(resumed.commanded());
                assertThat(commanded)
                        .as("no command is lost, and none has a second id")
                        .containsExactlyInAnyOrderElementsOf(uninterrupted.commanded());
            }
            try (JournalReader reader = JournalReader.open(file)) {
                assertThat(reader.entries()).as("crash after %d", crash).isEqualTo(whole.entries());
            }
        }
    }

    @Test
    void replayingGivesTheSameEffects() throws IOException {
        Path file = folder.resolve("replayed");
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, OPTIONS)) {
            Tour.fresh(journal).run();
        }

        try (JournalReader reader = JournalReader.open(file)) {
            List<Effect> effects = new ArrayList<>();
            reader.replay(
                    Tour.engine(), 1, reader.lastIndex(), (index, at, input, ofStep, view) -> effects.addAll(ofStep));
            assertThat(effects).isEqualTo(uninterrupted.effects());

            List<Effect> fromTheMiddle = new ArrayList<>();
            reader.replay(
                    Tour.engine(),
                    9,
                    reader.lastIndex(),
                    (index, at, input, ofStep, view) -> fromTheMiddle.addAll(ofStep));
            assertThat(fromTheMiddle).isNotEmpty().isEqualTo(lastOf(effects, fromTheMiddle.size()));
        }
    }

    @Test
    void aSnapshotOfAnotherVersionIsPassedOver() throws Exception {
        Path file = folder.resolve("older");
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, OPTIONS)) {
            Tour.fresh(new Spoiling(journal)).run();
        }

        try (JournalReader reader = JournalReader.open(file)) {
            Engine engine = Tour.engine();
            assertThat(StateCodec.encode(reader.stateAt(reader.lastIndex(), engine)))
                    .isEqualTo(uninterrupted.stateBytes());
        }
    }

    private static List<Effect> lastOf(List<Effect> effects, int n) {
        return effects.subList(effects.size() - n, effects.size());
    }

    /** A real journal, of whose files a copy is taken after an entry: what the disk holds when the process dies there. */
    private static final class CrashingJournal extends Forwarding {
        private final SqliteJournal live;
        private final long crashAfter;
        private final Path copy;

        CrashingJournal(SqliteJournal live, long crashAfter, Path copy) {
            super(live);
            this.live = live;
            this.crashAfter = crashAfter;
            this.copy = copy;
        }

        /** Gives the commands that left before the crash. */
        Set<Long> runUntilCrash() throws IOException {
            Tour tour = Tour.fresh(this);
            try {
                if (crashAfter == 0) {
                    die();
                } else {
                    tour.run();
                    die();
                }
            } catch (IllegalStateException died) {
                assertThat(died).hasMessageContaining("crash");
            }
            live.close();
            return tour.commanded();
        }

        @Override
        public void append(List<JournalEntry> entries, Durability durability) throws IOException {
            if (lastIndex() == crashAfter) {
                die();
                throw new IOException("crash");
            }
            super.append(entries, durability);
        }

        private void die() throws IOException {
            if (Files.exists(copy)) {
                return;
            }
            Files.copy(live.file(), copy);
            if (Files.exists(Database.log(live.file()))) {
                Files.copy(Database.log(live.file()), Database.log(copy));
            }
        }
    }

    /** Writes snapshots that no program can read. */
    private static final class Spoiling extends Forwarding {
        Spoiling(InputJournal journal) {
            super(journal);
        }

        @Override
        public void offerSnapshot(Supplier<byte[]> state) throws IOException {
            super.offerSnapshot(() -> new byte[] {99, 99, 99});
        }
    }

    /** Passes everything on. */
    private abstract static class Forwarding implements InputJournal {
        private final InputJournal journal;

        Forwarding(InputJournal journal) {
            this.journal = journal;
        }

        @Override
        public long lastIndex() {
            return journal.lastIndex();
        }

        @Override
        public long lastMillis() {
            return journal.lastMillis();
        }

        @Override
        public void append(List<JournalEntry> entries, Durability durability) throws IOException {
            journal.append(entries, durability);
        }

        @Override
        public void offerSnapshot(Supplier<byte[]> state) throws IOException {
            journal.offerSnapshot(state);
        }

        @Override
        public void sync() throws IOException {
            journal.sync();
        }

        @Override
        public void close() throws IOException {
            journal.close();
        }
    }
}
