package org.sami.pair.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.pair.postgres.Protection.State;
import org.sami.spn.journal.StoredJournal;

/** Several sessions in one pair, and whether somebody waits to go on with one. Real databases; says so in a line where no PostgreSQL is installed. */
@Tag("long")
@Timeout(180)
class PairSessionsTest {
    @TempDir
    Path root;

    @Test
    void aReplicaStaysOneWhileAnotherSessionOfThePairGoesOn() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases)) {
            StoredJournal tuesday = sessions.create("tuesday");
            sessions.create("monday").close(); // given back

            Future<StoredJournal> waiting = sessions.takeOver("monday");

            sessions.awaitWords("the session tuesday of this pair goes on at the other base");
            assertThat(BasePair.open(bases.second).part()).isEqualTo(BasePair.Part.REPLICA);
            tuesday.close();
            try (StoredJournal taken = waiting.get()) {
                assertThat(taken.lastIndex()).isZero();
            }
        }
    }

    @Test
    void aSessionIsProtectedOnlyWhileABaseWaitsToGoOnWithIt() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor()) {
            sessions.await(State.COPIED);
            try (StandbyPresence presence = BasePair.open(bases.second).standBy("sami")) {
                sessions.await(State.PROTECTED);
            }
            sessions.await(State.COPIED); // it said no word of its end, as one that was killed
        }
    }

    @Test
    void theStandbyOfOneSessionProtectsNoOtherAndItsEndLeavesNoOtherAlone() throws Exception {
        try (TwoBases bases = TwoBases.paired(root, WhenCut.TAKE_OVER);
                PairSessions sessions = new PairSessions(bases);
                StandbyMonitor monitor = sessions.monitor();
                StandbyMonitor ofOther = sessions.monitorOfOther("o'ther \\ one")) {
            sessions.await(State.COPIED);
            sessions.awaitOfOther(State.COPIED);
            BasePair second = BasePair.open(bases.second);

            StandbyPresence presence = second.standBy("sami");
            sessions.await(State.PROTECTED);
            assertThat(sessions.toldOther()).isEmpty();
            assertThat(BasePair.open(bases.first).standing()).contains("and waits for sami");

            try (StandbyPresence other = second.standBy("o'ther \\ one")) {
                sessions.awaitOfOther(State.PROTECTED);
                assertThat(presence.leave()).isTrue();
                sessions.await(State.COPIED);
                assertThat(sessions.toldOther()).isEmpty();
                assertThat(other.leave()).isTrue(); // the last of them
            }
            sessions.awaitOfOther(State.ALONE);
            sessions.await(State.ALONE);
        }
    }
}
