package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.engine.SubMissionNets.CHILD;
import static org.sami.spn.engine.SubMissionNets.taking;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;

/** Aborts and completions of missions with sub-missions (R-END-*). */
class EndingRulesTest {
    @Test
    void abortEndsAMissionAndAllDescendantsAndWithdrawsTheirCommands() {
        Session s = new Session(taking().build(), CHILD);
        long m = s.join("A").start("parent");
        s.news("News", "A");
        long child = s.idOf("child");

        s.step(new Input.AbortMission(m));

        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
        assertThat(s.outcome(child)).contains(Outcome.ABORTED);
        assertThat(s.last())
                .contains(new Effect.CommandsWithdrawn(m, List.of()), new Effect.CommandsWithdrawn(child, List.of()));
        assertThat(s.view().missions()).isEmpty();
        assertThat(s.view().openActivations()).isEmpty();
    }

    @Test
    void aTransitionMayInterceptAnAbort() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("caught", "AbortReceived")
                .in("s", "caught", "generic >= 1")
                .out("caught", "home", "take all any")
                .build());
        long m = s.join("A").start("net");

        s.step(new Input.AbortMission(m));
        assertThat(s.marking(m, "home")).isEqualTo("generic A");
        s.step(new Input.AbortMission(m));

        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
    }

    @Test
    void completeEndsAMissionAsCompleted() {
        Session s = new Session(CHILD);
        long m = s.join("A").start("child");

        s.step(new Input.CompleteMission(m));

        assertThat(s.outcome(m)).contains(Outcome.COMPLETED);
    }

    @Test
    void anAbortedChildIsAnOutcomeOfItsOwn() {
        Session s = new Session(
                taking().transition("aborted", "SubMissionAborted")
                        .in("sub", "aborted", "relevant all")
                        .out("aborted", "lost", "take all relevant")
                        .build(),
                CHILD);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A");

        s.step(new Input.AbortMission(s.idOf("child")));

        assertThat(s.fired()).containsExactly("aborted");
        assertThat(s.marking(m, "lost")).isEqualTo("A");
        assertThat(s.view().decisions()).isEmpty();
    }

    @Test
    void whereNobodyWaitsForAnAbortedChildTheOperatorDecides() {
        for (boolean giveBack : new boolean[] {true, false}) {
            Session s = new Session(taking().build(), CHILD);
            long m = s.join("A").start("parent");
            s.news("News", "A");
            s.step(new Input.AbortMission(s.idOf("child")));
            assertThat(s.allFired()).doesNotContain("back");
            assertThat(s.onlyDecision().automatic()).contains(new Answer.YesNo(true));

            s.decide(new Answer.YesNo(giveBack));

            assertThat(s.marking(m, giveBack ? "x" : "sub")).isEqualTo("A");
        }
    }
}
