package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;

/**
 * Cuts the write-ahead log at every byte, flips a bit in bytes of both files, and opens what is left: the state is that
 * after some entry, or the file is refused by name; never a wrong state. The whole of both files with
 * {@code -Djournal.everyByte=true}, else every nth byte.
 */
@Tag("long")
class JournalDamageTest {
    private static final boolean EVERY_BYTE = Boolean.getBoolean("journal.everyByte");
    private static final int CASES = EVERY_BYTE ? Integer.MAX_VALUE : 700;
    private static final JournalOptions OPTIONS =
            JournalOptions.DEFAULT.withSnapshotEvery(4).withoutSync().withPages(512, 0);

    @TempDir
    static Path folder;

    private static Engine engine;
    private static List<JournalEntry> entries;
    private static final List<byte[]> TRUTH = new ArrayList<>();
    private static byte[] liveFile;
    private static byte[] liveLog;
    private static byte[] closedFile;

    private int opened;
    private final List<String> refused = new ArrayList<>();
    private int shortened;

    @BeforeAll
    static void runAMission() throws IOException {
        Path file = folder.resolve("whole.journal");
        engine = Tour.engine();
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, OPTIONS)) {
            Tour.fresh(journal).run();
            liveFile = Files.readAllBytes(file);
            liveLog = Files.readAllBytes(Database.log(file));
        }
        closedFile = Files.readAllBytes(file);
        try (JournalReader reader = JournalReader.open(file)) {
            entries = reader.entries();
        }
        EngineState state = engine.newState();
        TRUTH.add(StateCodec.encode(state));
        for (JournalEntry entry : entries) {
            engine.step(state, entry.atMillis(), entry.input());
            TRUTH.add(StateCodec.encode(state));
        }
    }

    @Test
    void theMissionIsWorthDamaging() throws IOException {
        assertThat(entries).hasSizeGreaterThan(10);
        assertThat(liveLog.length).isGreaterThan(10_000);
        assertThat(open(liveFile, liveLog)).isEqualTo(entries.size());
        assertThat(open(closedFile, new byte[0])).isEqualTo(entries.size());
    }

    @Test
    void aLogThatIsCutAnywhereGivesAPrefix() throws IOException {
        long longest = 0;
        for (int length = 0; length <= liveLog.length; length += stride(liveLog.length)) {
            long index = open(liveFile, Arrays.copyOf(liveLog, length));
            assertThat(index)
                    .as("a longer log holds no less, cut at %d", length)
                    .isGreaterThanOrEqualTo(longest);
            longest = index;
        }
        assertThat(refused).as("a cut log is what a crash leaves").isEmpty();
        assertThat(shortened).isPositive();
    }

    @Test
    void aFlippedBitInTheLogGivesAPrefix() throws IOException {
        flipEverywhere(liveLog, damaged -> open(liveFile, damaged));

        assertThat(refused).isEmpty();
        assertThat(shortened).isPositive();
    }

    @Test
    void aFlippedBitInTheFileBesideItsLogGivesAPrefixOrIsRefused() throws IOException {
        flipEverywhere(liveFile, damaged -> open(damaged, liveLog));

        assertThat(opened).isPositive();
    }

    @Test
    void aFlippedBitInAClosedJournalGivesAPrefixOrIsRefused() throws IOException {
        flipEverywhere(closedFile, damaged -> open(damaged, new byte[0]));

        assertThat(opened).isPositive();
        assertThat(refused).isNotEmpty();
        assertThat(shortened).isPositive();
    }

    private static int stride(int length) {
        return Math.max(1, (int) Math.ceil(length / (double) CASES));
    }

    private void flipEverywhere(byte[] content, Opening opening) throws IOException {
        SplittableRandom random = new SplittableRandom(20_150_301);
        int stride = stride(content.length);
        for (int start = 0; start < content.length; start += stride) {
            int position = Math.min(content.length - 1, start + random.nextInt(stride));
            byte[] damaged = content.clone();
            damaged[position] ^= (byte) (1 << random.nextInt(8));
            opening.open(damaged);
        }
    }

    /** Opens files of these contents and holds what comes of it to the truth; -1 if they are refused. */
    private long open(byte[] file, byte[] log) throws IOException {
        Path copy = folder.resolve("damaged.journal");
        clear();
        Files.write(copy, file);
        if (log.length > 0) {
            Files.write(Database.log(copy), log);
        }
        int index;
        try (SqliteJournal journal = SqliteJournal.open(copy, OPTIONS)) {
            index = (int) journal.lastIndex();
            assertThat(journal.header()).isEqualTo(Tour.HEADER);
            assertThat(StateCodec.encode(journal.restore(engine))).isEqualTo(TRUTH.get(index));
            opened++;
            if (index < entries.size()) {
                shortened++;
                journal.append(entries.subList(index, entries.size()), Durability.PROCESS);
            }
        } catch (JournalException named) {
            assertThat(named.where()).isEqualTo(copy.toString());
            assertThat(named.entry()).isBetween(0L, (long) entries.size());
            refused.add(named.getMessage());
            return -1;
        }
        checkContinued(copy);
        return index;
    }

    /** What was written after the damage is all there. */
    private static void checkContinued(Path copy) throws IOException {
        try (JournalReader reader = JournalReader.open(copy)) {
            assertThat(reader.recovery().damage()).isEmpty();
            assertThat(reader.entries()).isEqualTo(entries);
            assertThat(StateCodec.encode(reader.stateAt(entries.size(), engine)))
                    .isEqualTo(TRUTH.get(entries.size()));
        }
    }

    private static void clear() throws IOException {
        try (DirectoryStream<Path> old = Files.newDirectoryStream(folder, "damaged.*")) {
            for (Path path : old) {
                Files.delete(path);
            }
        }
    }

    @FunctionalInterface
    private interface Opening {
        long open(byte[] damaged) throws IOException;
    }
}
