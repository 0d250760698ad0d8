package org.sami.pair.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.time.Clock;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.journal.postgres.Connections;
import org.sami.pair.postgres.Protection.State;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.protocol.Input;

/** What a pair does where one of both fails, or a person decides. Real databases; says so in a line where no PostgreSQL is installed. */
@Tag("long")
@Timeout(180)
class PairFaultTest {
    @TempDir
    Path root;

    private final BlockingQueue<Protection> protections = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> said = new LinkedBlockingQueue<>();
    private final ExecutorService thread = Executors.newSingleThreadExecutor();

    @AfterEach
    void end() {
        thread.shutdownNow();
    }

    @Test
    void aHolderThatGoesAloneAtACutWritesOnWithoutItsStandbyAndIsProtectedAgainWhenItIsBack() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                StandbyMonitor monitor = monitor(bases);
                StoredJournal journal = create(bases)) {
            await(State.COPIED);
            PairDatabase.of(bases.second).stop();

            await(State.ALONE);
            write(journal, 1);

            PairDatabase.of(bases.second).start();
            await(State.COPIED);
            write(journal, 2);
            assertThat(entries(bases.second)).isEqualTo(2);
        }
    }

    @Test
    void aHolderOfAPairThatTakesOverStopsWithoutItsStandbyUntilAPersonSaysThatItIsOff() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                StandbyMonitor monitor = monitor(bases);
                StoredJournal journal = create(bases)) {
            await(State.COPIED);
            PairDatabase.of(bases.second).stop();
            await(State.SILENT);

            assertThatThrownBy(() -> journal.append(List.of(entry(1)), Durability.POWER))
                    .isInstanceOf(IOException.class);

            BasePair.open(bases.first).goAlone();
            await(State.ALONE);
            recover(journal);
            write(journal, journal.lastIndex() + 1);
            assertThatThrownBy(BasePair.open(bases.second)::goAlone)
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("this base is the standby");
        }
    }

    @Test
    void aStandbyThatEndsInOrderLeavesTheHolderToGoOnAlone() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                StandbyMonitor monitor = monitor(bases);
                StoredJournal journal = create(bases)) {
            StandbyPresence presence = BasePair.open(bases.second).standBy();
            await(State.PROTECTED);

            assertThat(presence.leave()).isTrue();

            await(State.ALONE);
            PairDatabase.of(bases.second).stop();
            write(journal, 1);
        }
    }

    @Test
    void aReplicaThatWasPromotedByMistakeTakesTheSessionAndTheHolderStops() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                StandbyMonitor monitor = monitor(bases);
                StoredJournal journal = create(bases)) {
            await(State.COPIED);
            write(journal, 1);
            Future<StoredJournal> waiting = thread.submit(() -> standBy(bases));
            awaitWords("this base goes on with it by itself");

            try (Connection second = new PairConnections(bases.second, bases.second.settings()).own(30)) {
                Connections.run(second, "SELECT pg_promote(true, 30)");
            }

            await(State.REPLACED);
            try (StoredJournal taken = waiting.get()) {
                write(taken, 2);
                assertThatThrownBy(() -> journal.append(List.of(entry(2)), Durability.POWER))
                        .isInstanceOf(IOException.class);
                assertThat(epoch(bases.second)).isGreaterThan(1_000_000 + epoch(bases.first) - 1);
            }
        }
    }

    @Test
    void aTakeOverByAPersonLosesNothingWhereBothAnswer() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                StandbyMonitor monitor = monitor(bases);
                StoredJournal journal = create(bases)) {
            await(State.COPIED);
            write(journal, 1);
            BasePair second = BasePair.open(bases.second);
            Future<StoredJournal> waiting = thread.submit(() -> standBy(bases));
            awaitWords("the session is held by");

            assertThat(second.lossOfTakeOver()).isEmpty();
            assertThat(second.takeOver("sami", false)).isPresent();

            try (StoredJournal taken = waiting.get()) {
                assertThat(taken.lastIndex()).isEqualTo(1);
                write(taken, 2);
            }
            assertThatThrownBy(() -> journal.append(List.of(entry(2)), Durability.POWER))
                    .isInstanceOf(IOException.class);
            assertThatThrownBy(() -> second.takeOver("sami", false)).isInstanceOf(PairException.class);
        }
    }

    @Test
    void aTakeOverByAPersonSaysWhatIsLostWhereTheHolderDoesNotAnswer() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                StandbyMonitor monitor = monitor(bases)) {
            await(State.COPIED);
            StoredJournal journal = create(bases);
            write(journal, 1);
            BasePair second = BasePair.open(bases.second);
            Future<StoredJournal> waiting = thread.submit(() -> standBy(bases));
            awaitWords("the session is held by");
            PairDatabase.of(bases.first).stop();
            awaitWords("who may go on without this base");
            assertThat(waiting.isDone()).isFalse();

            assertThat(second.lossOfTakeOver().orElseThrow())
                    .startsWith(bases.firstAddress + " does not answer. This base received the last of it at ")
                    .endsWith("is lost");
            second.takeOver("sami", true);

            try (StoredJournal taken = waiting.get()) {
                assertThat(taken.lastIndex()).isEqualTo(1);
            }
        }
    }

    @Test
    void aHolderThatWentAloneEndsOnceItSeesThatTheOtherWentOn() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                StandbyMonitor monitor = monitor(bases);
                StoredJournal journal = create(bases)) {
            await(State.COPIED);
            write(journal, 1);

            try (Connection second = new PairConnections(bases.second, bases.second.settings()).own(30)) {
                Connections.run(second, "SELECT pg_promote(true, 30)"); // as 'crw take-over --confirm' does
            }

            await(State.REPLACED);
        }
    }

    @Test
    void anOldReplicaWhoseSessionWasGivenBackDoesNotTakeItWhileItGetsNothing() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER)) {
            create(bases).close();
            PairDatabase.of(bases.first).stop();

            Future<StoredJournal> waiting = thread.submit(() -> standBy(bases));

            awaitWords("who may go on without this base");
            assertThat(waiting.isDone()).isFalse();
        }
    }

    @Test
    void aBaseThatHasTheSessionDoesNotRejoin() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER)) {
            assertThatThrownBy(BasePair.open(bases.first)::checkRejoin)
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("is a replica: there is nothing to follow");
            BasePair.open(bases.second).checkRejoin();
        }
    }

    private StandbyMonitor monitor(TwoBases bases) throws IOException {
        return BasePair.open(bases.first).monitor(Clock.systemUTC(), (now, since) -> protections.add(now));
    }

    private void await(State state) throws InterruptedException {
        State now = protections.take().state();
        while (now != state) {
            now = protections.take().state();
        }
    }

    private void awaitWords(String words) throws InterruptedException {
        String line = said.take();
        while (!line.contains(words)) {
            line = said.take();
        }
    }

    private static JournalAddress address(PairFolder folder) throws IOException {
        return JournalAddress.parse(BasePair.open(folder).journal("sami").text());
    }

    private static StoredJournal create(TwoBases bases) throws IOException {
        return address(bases.first)
                .create(JournalHeader.of("plans", Map.of(), Map.of("kind", "session")), JournalOptions.DEFAULT);
    }

    private StoredJournal standBy(TwoBases bases) throws IOException {
        return address(bases.second).takeOver(JournalOptions.DEFAULT, said::add, Optional::empty);
    }

    private static void write(StoredJournal journal, long index) throws IOException {
        journal.append(List.of(entry(index)), Durability.POWER);
    }

    private static JournalEntry entry(long index) {
        return new JournalEntry(index, index * 1000, new Input.ProxyJoined("boat" + index));
    }

    /** As a session does it: again until the database takes it. */
    private static void recover(StoredJournal journal) throws IOException {
        assertThat(journal.isRecoverable()).isTrue();
        journal.recover();
    }

    private static long entries(PairFolder folder) throws Exception {
        return number(folder, "SELECT count(*) FROM sami.entries");
    }

    private static long epoch(PairFolder folder) throws Exception {
        return number(folder, "SELECT epoch FROM sami.lease");
    }

    private static long number(PairFolder folder, String sql) throws Exception {
        try (Connection connection = new PairConnections(folder, folder.settings()).own()) {
            return Long.parseLong(Connections.text(connection, sql));
        }
    }
}
