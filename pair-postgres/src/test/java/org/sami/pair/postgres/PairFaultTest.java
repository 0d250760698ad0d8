package org.sami.pair.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.util.List;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.journal.postgres.Connections;
import org.sami.journal.postgres.TakeOver;
import org.sami.pair.postgres.Protection.State;
import org.sami.spn.host.Durability;
import org.sami.spn.journal.StoredJournal;

/** What a pair does where one of both fails, or a person decides. Real databases; says so in a line where no PostgreSQL is installed. */
@Tag("long")
@Timeout(180)
class PairFaultTest {
    @TempDir
    Path root;

    @Test
    void aHolderThatGoesAloneAtACutWritesOnWithoutItsStandbyAndIsProtectedAgainWhenItIsBack() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor();
                StoredJournal journal = sessions.create("sami")) {
            sessions.await(State.COPIED);
            PairDatabase.of(bases.second).stop();

            sessions.await(State.ALONE);
            PairSessions.write(journal, 1);

            PairDatabase.of(bases.second).start();
            sessions.await(State.COPIED);
            PairSessions.write(journal, 2);
            assertThat(entries(bases.second)).isEqualTo(2);
        }
    }

    @Test
    void aHolderOfAPairThatTakesOverStopsWithoutItsStandbyUntilAPersonSaysThatItIsOff() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor();
                StoredJournal journal = sessions.create("sami")) {
            sessions.await(State.COPIED);
            PairDatabase.of(bases.second).stop();
            sessions.await(State.SILENT);

            assertThatThrownBy(() -> journal.append(List.of(PairSessions.entry(1)), Durability.POWER))
                    .isInstanceOf(IOException.class);

            BasePair.open(bases.first).goAlone();
            sessions.await(State.ALONE);
            recover(journal);
            PairSessions.write(journal, journal.lastIndex() + 1);
            assertThatThrownBy(BasePair.open(bases.second)::goAlone)
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("this base is the standby");
        }
    }

    @Test
    void aStandbyThatEndsInOrderLeavesTheHolderToGoOnAlone() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor();
                StoredJournal journal = sessions.create("sami")) {
            StandbyPresence presence = BasePair.open(bases.second).standBy("sami");
            sessions.await(State.PROTECTED);

            assertThat(presence.leave()).isTrue();

            sessions.await(State.ALONE);
            PairDatabase.of(bases.second).stop();
            PairSessions.write(journal, 1);
        }
    }

    @Test
    void aReplicaThatWasPromotedByMistakeTakesTheSessionAndTheHolderStops() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor();
                StoredJournal journal = sessions.create("sami")) {
            sessions.await(State.COPIED);
            PairSessions.write(journal, 1);
            Future<StoredJournal> waiting = sessions.takeOver("sami");
            sessions.awaitWords("this base goes on with it by itself");

            try (Connection second = new PairConnections(bases.second, bases.second.settings()).own(30)) {
                Connections.run(second, "SELECT pg_promote(true, 30)");
            }

            sessions.await(State.REPLACED);
            try (StoredJournal taken = waiting.get()) {
                PairSessions.write(taken, 2);
                assertThatThrownBy(() -> journal.append(List.of(PairSessions.entry(2)), Durability.POWER))
                        .isInstanceOf(IOException.class);
                assertThat(epoch(bases.second)).isGreaterThan(1_000_000 + epoch(bases.first) - 1);

                BasePair second = BasePair.open(bases.second);
                assertThatThrownBy(() -> second.takeOver("sami", true))
                        .hasMessageContaining("nothing is to be taken over");
                assertThat(TakeOver.takeFromOtherDatabase(second.journal("sami")))
                        .isEmpty();
                PairSessions.write(taken, 3);
            }
        }
    }

    @Test
    void aReplicaThatWasPromotedWhileTheOtherIsSilentHasTheSessionOnlyAtTheWordOfAPerson() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor()) {
            sessions.await(State.COPIED);
            StoredJournal journal = sessions.create("sami");
            PairSessions.write(journal, 1);
            try (Connection own = new PairConnections(bases.second, bases.second.settings()).own(30)) {
                Connections.run(own, "SELECT pg_promote(true, 30)");
            }
            PairDatabase.of(bases.first).stop();
            BasePair second = BasePair.open(bases.second);

            assertThatThrownBy(() -> second.checkedPart("sami"))
                    .isInstanceOf(PairException.class)
                    .hasMessageContaining("both would command. If it is off: crw take-over --confirm");
            assertThat(second.lossOfTakeOver("sami").orElseThrow())
                    .contains("both command")
                    .endsWith("is lost");
            assertThat(second.takeOver("sami", true)).isPresent();

            assertThat(second.checkedPart("sami")).isEqualTo(BasePair.Part.DATABASE);
        }
    }

    @Test
    void aTakeOverByAPersonLosesNothingWhereBothAnswer() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor();
                StoredJournal journal = sessions.create("sami")) {
            sessions.await(State.COPIED);
            PairSessions.write(journal, 1);
            BasePair second = BasePair.open(bases.second);
            Future<StoredJournal> waiting = sessions.takeOver("sami");
            sessions.awaitWords("the session is held by");

            assertThat(second.lossOfTakeOver("sami")).isEmpty();
            assertThat(second.takeOver("sami", false)).isPresent();

            try (StoredJournal taken = waiting.get()) {
                assertThat(taken.lastIndex()).isEqualTo(1);
                PairSessions.write(taken, 2);
            }
            assertThatThrownBy(() -> journal.append(List.of(PairSessions.entry(2)), Durability.POWER))
                    .isInstanceOf(IOException.class);
            assertThatThrownBy(() -> second.takeOver("sami", false)).isInstanceOf(PairException.class);
        }
    }

    @Test
    void aTakeOverByAPersonSaysWhatIsLostWhereTheHolderDoesNotAnswer() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.ALONE);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor()) {
            sessions.await(State.COPIED);
            StoredJournal journal = sessions.create("sami");
            PairSessions.write(journal, 1);
            BasePair second = BasePair.open(bases.second);
            Future<StoredJournal> waiting = sessions.takeOver("sami");
            sessions.awaitWords("the session is held by");
            PairDatabase.of(bases.first).stop();
            sessions.awaitWords("who may go on without this base");
            assertThat(waiting.isDone()).isFalse();

            assertThat(second.lossOfTakeOver("sami").orElseThrow())
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
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor();
                StoredJournal journal = sessions.create("sami")) {
            sessions.await(State.COPIED);
            PairSessions.write(journal, 1);

            try (Connection second = new PairConnections(bases.second, bases.second.settings()).own(30)) {
                Connections.run(second, "SELECT pg_promote(true, 30)"); // as 'crw take-over --confirm' does
            }

            sessions.await(State.REPLACED);
        }
    }

    @Test
    void anOldReplicaWhoseSessionWasGivenBackDoesNotTakeItWhileItGetsNothing() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases)) {
            sessions.create("sami").close();
            PairDatabase.of(bases.first).stop();

            Future<StoredJournal> waiting = sessions.takeOver("sami");

            sessions.awaitWords("who may go on without this base");
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
