package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;

/** What an interrupt takes out of instances and their descendants (R-INT-7). */
class WithdrawalRulesTest {
    private static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .end("e")
            .transition("over", "Done")
            .waitForAll("over")
            .in("c", "over", "relevant all")
            .out("over", "e", "take all relevant")
            .build();

    /** A plan that runs another on a place that all robots enter at once. */
    private static NetBuilder around(String id, String inner) {
        return new NetBuilder(id)
                .start(id + "-start")
                .transition(id + "-in")
                .in(id + "-start", id + "-in", "proxy >= 1")
                .out(id + "-in", id + "-sub", "take all proxy")
                .sub(id + "-sub", inner);
    }

    private static Session threeLevels() {
        Plan middle = around("middle", "child")
                .end("middle-end")
                .transition("middle-out")
                .in("middle-sub", "middle-out", "always")
                .out("middle-out", "middle-end", "take all sub")
                .build();
        Plan root = around("root", "middle")
                .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Pull")), Map.of())
                .in("root-sub", "pull", "relevant >= 1")
                .out("pull", "away", "take all relevant")
                .build();
        Session s = new Session(root, middle, CHILD);
        s.join("A", "B").start("root");
        return s;
    }

    @Test
    void aPullReachesInstancesOfInstances() {
        Session s = threeLevels();
        long root = s.idOf("root");
        long middle = s.idOf("middle");
        long child = s.idOf("child");

        s.press("Pull", "B");
        assertThat(s.marking(root)).containsEntry("root-sub", "A").containsEntry("away", "B");
        assertThat(s.marking(middle, "middle-sub")).isEqualTo("A");
        assertThat(s.marking(child, "c")).isEqualTo("A");

        s.press("Pull", "A");
        assertThat(s.marking(root, "away")).isEqualTo("B A");
        assertThat(s.outcome(middle)).contains(Outcome.ABORTED);
        assertThat(s.outcome(child)).contains(Outcome.ABORTED);
        assertThat(s.outcome(root)).isEmpty();
    }

    @Test
    void aPullWithdrawsTheCommandsOfEveryMissionThatTheRobotIsIn() {
        Session s = threeLevels();

        s.press("Pull", "B");

        assertThat(s.last())
                .contains(
                        new Effect.CommandsWithdrawn(s.idOf("root"), List.of("B")),
                        new Effect.CommandsWithdrawn(s.idOf("middle"), List.of("B")),
                        new Effect.CommandsWithdrawn(s.idOf("child"), List.of("B")));
    }

    @Test
    void aMissionThatEntersItsEndPlaceWithdrawsItsCommandsBeforeThePlaceAsks() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Do")
                .end("e")
                .output("e", "Do")
                .transition("over", "Done")
                .in("s", "over", "proxy >= 1")
                .out("over", "e", "take all proxy")
                .build());
        long m = s.join("A").start("net");

        s.answer("Done", "s", "A");

        assertThat(s.last())
                .containsSubsequence(
                        new Effect.CommandsWithdrawn(m, List.of()),
                        new Effect.Activated(s.latest("e")),
                        new Effect.MissionEnded(m, Outcome.ENDED));
    }

    @Test
    void aCopyThatStaysKeepsTheRobotInTheInstance() {
        Plan root = new NetBuilder("root")
                .start("s")
                .sub("sub", "child")
                .transition("send")
                .in("s", "send", "proxy >= 1")
                .out("send", "two", "take all proxy")
                .out("send", "two", "take all proxy")
                .transition("both")
                .in("two", "both", "proxy >= 2")
                .out("both", "sub", "take all proxy")
                .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Pull")), Map.of())
                .in("sub", "pull", "proxy >= 1")
                .out("pull", "away", "take 1 proxy")
                .build();
        Session s = new Session(root, CHILD);
        long m = s.join("A").start("root");
        assertThat(s.marking(m, "sub")).isEqualTo("A A");

        s.press("Pull");
        assertThat(s.marking(s.idOf("child"), "c")).isEqualTo("A A");
        s.press("Pull");

        assertThat(s.marking(m, "away")).isEqualTo("A A");
        assertThat(s.missionOf("child")).isEmpty();
    }
}
