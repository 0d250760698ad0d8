package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Returns of static sub-missions (R-SHR-*) and return values (R-RET-*). */
class ReturnRulesTest {
    /** Robots work one by one; who is done or has failed goes to an end place that returns "good" or "bad". */
    private static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .end("good", "bad")
            .output("good", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("good"))), Map.of())
            .output("bad", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("bad"))), Map.of())
            .transition("ok", "Done")
            .in("c", "ok", "relevant all")
            .out("ok", "good", "take all relevant")
            .transition("nok", "Failed")
            .in("c", "nok", "relevant all")
            .out("nok", "bad", "take all relevant")
            .build();

    private static Map<String, Value> value(String text) {
        return Map.of("value", new TextValue(text));
    }

    private static Map<String, Value> button(String name) {
        return Map.of("interruptName", new TextValue(name));
    }

    /** Robots are sent to the sub-mission by News; "Open" puts a generic token into the gate; "Pull" takes robots away. */
    private static NetBuilder parent(boolean shared) {
        return new NetBuilder("parent")
                .start("s")
                .sub("sub", "child", shared, Map.of(), Map.of())
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "sub", "take all relevant")
                .input("open", "Interrupt", button("Open"), Map.of())
                .out("open", "gate", "add 1 generic")
                .input("pull", "Interrupt", button("Pull"), Map.of())
                .in("sub", "pull", "relevant >= 1")
                .out("pull", "away", "take all relevant");
    }

    /** Takes what came back with a value to a place, once the gate is open. */
    private static NetBuilder gated(NetBuilder net, String transition, String value, String to) {
        return net.input(transition, "CheckReturn", value(value), Map.of())
                .in("sub", transition, "always")
                .in("gate", transition, "generic >= 1")
                .out(transition, to, "take all sub", "take 1 generic");
    }

    private static Session sent(NetBuilder net, String... robots) {
        Session s = new Session(net.build(), CHILD);
        s.join(robots).start("parent");
        for (String robot : robots) {
            s.news("News", robot);
        }
        return s;
    }

    private static void answer(Session s, String type, int activation, String robot) {
        s.answer(type, s.activations("c").get(activation), robot);
    }

    @Test
    void returnsOfAStaticInstanceWaitInOrderAndNoneReplacesAnother() {
        Session s = sent(gated(parent(true), "out", "good", "d"), "A", "B", "C");
        long m = s.idOf("parent");
        answer(s, "Done", 1, "B");
        answer(s, "Done", 0, "A");
        assertThat(s.marking(m, "sub")).isEqualTo("A B C");

        s.press("Open");
        assertThat(s.marking(m, "d")).isEqualTo("B generic");
        s.press("Open");

        assertThat(s.marking(m, "d")).isEqualTo("B generic A generic");
        assertThat(s.marking(m, "sub")).isEqualTo("C");
    }

    @Test
    void aCheckThatNamesASubMissionHearsOfNoOther() {
        for (boolean shared : new boolean[] {false, true}) {
            for (String named : List.of("child", "other")) {
                Map<String, Value> wanted =
                        Map.of("value", new TextValue("good"), "subMission", new PlanReference(named));
                Session s = sent(
                        parent(shared)
                                .input("out", "CheckReturn", wanted, Map.of())
                                .in("sub", "out", "always")
                                .out("out", "d", "take all sub"),
                        "A");

                answer(s, "Done", 0, "A");

                assertThat(s.marking(s.idOf("parent"), "d")).isEqualTo(named.equals("child") ? "A" : "");
            }
        }
    }

    @Test
    void aFiringTakesTheTokensOfTheStaticReturnWhoseValueItChecked() {
        NetBuilder net = parent(true).input("failed", "CheckReturn", value("bad"), Map.of());
        gated(net.in("sub", "failed", "always").out("failed", "lost", "take all sub"), "out", "good", "d");
        Session s = sent(net, "A", "B");
        long m = s.idOf("parent");

        answer(s, "Done", 0, "A");
        answer(s, "Failed", 1, "B");

        assertThat(s.fired()).containsExactly("nok", "failed");
        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "sub", "A", "lost", "B"));
        s.press("Open");
        assertThat(s.marking(m, "d")).isEqualTo("A generic");
    }

    @Test
    void aFiringTakesTheTokensOfTheVisitWhoseReturnValueItChecked() {
        NetBuilder net = parent(false).input("failed", "CheckReturn", value("bad"), Map.of());
        gated(net.in("sub", "failed", "always").out("failed", "lost", "take all sub"), "out", "good", "d");
        Session s = sent(net, "A", "B");
        long m = s.idOf("parent");

        answer(s, "Done", 0, "A");
        answer(s, "Failed", 1, "B");

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "sub", "A", "lost", "B"));
        s.press("Open");
        assertThat(s.marking(m, "d")).isEqualTo("A generic");
    }

    @Test
    void requirementsCountOnlyTheVisitWhoseReturnValueIsChecked() {
        NetBuilder net = parent(false)
                .input("both", "CheckReturn", value("good"), Map.of())
                .in("sub", "both", "proxy >= 2")
                .out("both", "d", "take all sub");
        Session s = sent(net, "A", "B");
        answer(s, "Done", 0, "A");
        answer(s, "Done", 1, "B");

        assertThat(s.allFired()).doesNotContain("both");
    }

    @Test
    void oneReturnIsOneOccurrenceForAllTransitionsThatCheckIt() {
        for (boolean shared : new boolean[] {true, false}) {
            NetBuilder net = gated(gated(parent(shared), "first", "good", "x"), "second", "good", "y");
            // Both robots enter by one visit; the dynamic instance goes on standing with what "first" leaves.
            Session s = new Session(net.out("first", "x", "take 1 sub").build(), CHILD);
            long m = s.join("A", "B").start("parent");
            s.news("News", "A", "B");
            s.answer("Done", "c", "A", "B");

            s.press("Open");
            s.press("Open");

            assertThat(s.allFired()).contains("first").doesNotContain("second");
            assertThat(s.marking(m, "y")).isEmpty();
        }
    }

    @Test
    void aReturnThatAnotherTransitionUsedIsNotCheckedAnyLonger() {
        NetBuilder net = gated(parent(true), "out", "good", "d")
                .transition("take", "Other")
                .in("sub", "take", "always")
                .out("take", "x", "take all sub");
        Session s = sent(net, "A", "B");
        long m = s.idOf("parent");
        answer(s, "Done", 0, "A");
        s.news("Other");
        assertThat(s.marking(m, "x")).isEqualTo("A");

        s.press("Open");
        assertThat(s.allFired()).doesNotContain("out");
        answer(s, "Done", 1, "B");

        assertThat(s.marking(m, "d")).isEqualTo("B generic");
    }

    @Test
    void theUnusedReturnOfARobotThatIsPulledIsVoid() {
        NetBuilder net = parent(true)
                .transition("out")
                .in("sub", "out", "always")
                .in("gate", "out", "generic >= 1")
                .out("out", "d", "take all sub", "take 1 generic");
        Session s = sent(net, "A", "B");
        long m = s.idOf("parent");
        answer(s, "Done", 0, "A");

        s.press("Pull", "A");
        assertThat(s.notes()).containsExactly(NoteKind.DISCARDED);
        s.press("Open");

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "sub", "B", "gate", "generic", "away", "A"));
        answer(s, "Done", 1, "B");
        assertThat(s.marking(m, "d")).isEqualTo("B generic");
    }

    @Test
    void theCheckedValueOfAVoidReturnIsVoidToo() {
        Session s = sent(gated(parent(true), "out", "good", "d"), "A", "B");
        long m = s.idOf("parent");
        answer(s, "Done", 0, "A");
        s.press("Pull", "A");
        answer(s, "Done", 1, "B");

        s.press("Open");
        s.press("Open");

        assertThat(s.allFired()).containsOnlyOnce("out");
        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "gate", "generic", "away", "A", "d", "B generic"));
    }

    @Test
    void ofSeveralRobotsOfOneReturnOnlyThePulledOneIsVoid() {
        Session s = new Session(gated(parent(true), "out", "good", "d").build(), CHILD);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A", "B");
        s.answer("Done", "c", "A", "B");

        s.press("Pull", "A");
        s.press("Open");

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "away", "A", "d", "B generic"));
    }

    @Test
    void aRobotThatAnInterruptPutsBackIntoThePlaceJoinsTheStaticInstanceAnewAndStandsThereOnce() {
        NetBuilder net = parent(true).input("again", "Interrupt", button("Again"), Map.of());
        Session s = sent(net.in("sub", "again", "relevant >= 1").out("again", "sub", "take all relevant"), "A", "B");

        s.press("Again", "A");

        assertThat(s.marking(s.idOf("parent"), "sub")).isEqualTo("B A");
        assertThat(s.marking(s.idOf("child"), "c")).isEqualTo("B A");
    }

    @Test
    void theReturnOfADroppedRobotIsVoid() {
        Session s = sent(gated(parent(true), "out", "good", "d"), "A", "B");
        long m = s.idOf("parent");
        answer(s, "Done", 0, "A");

        s.step(new Input.ProxyDropped("A", Ids.NONE));
        s.press("Open");

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "sub", "B", "gate", "generic"));
    }

    @Test
    void anAbortedStaticInstanceLeavesTheUnusedReturnsThatCameBefore() {
        NetBuilder net = gated(parent(true), "out", "good", "d")
                .transition("gone", "SubMissionAborted")
                .in("sub", "gone", "relevant all")
                .out("gone", "lost", "take all relevant");
        Session s = sent(net, "A", "B");
        long m = s.idOf("parent");
        answer(s, "Done", 0, "A");

        s.step(new Input.AbortMission(s.idOf("child")));
        assertThat(s.marking(m, "lost")).isEqualTo("B");
        s.press("Open");

        assertThat(s.marking(m, "d")).isEqualTo("A generic");
    }

    @Test
    void aRobotIsFreeWhenEveryStaticInstanceOnItsPlaceHasReturnedIt() {
        NetBuilder net = parent(true)
                .shared("sub", "child")
                .transition("out")
                .in("sub", "out", "proxy >= 1")
                .out("out", "d", "take all proxy");
        Session s = sent(net, "A");
        long m = s.idOf("parent");
        answer(s, "Done", 0, "A");
        assertThat(s.marking(m, "sub")).as("it still works in the other one").isEqualTo("A");

        answer(s, "Done", 1, "A");

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "d", "A"));
    }

    @Test
    void theReturnValueOfAVisitThatHasEndedIsNotChecked() {
        for (boolean before : new boolean[] {true, false}) {
            // "out" takes the robot for a task in the start place; "ok" would answer to the value of its instance.
            NetBuilder net = parent(false)
                    .task("T", "Measure", Map.of())
                    .transition("out")
                    .in("sub", "out", "proxy >= 1")
                    .in(before ? "s" : "work", "out", "task >= 1")
                    .out("out", "d", "take all sub")
                    .input("ok", "CheckReturn", value("good"), Map.of())
                    .in("sub", "ok", "always")
                    .in("gate", "ok", "generic >= 1")
                    .out("ok", "x", "take 1 generic")
                    .transition("task", "Other")
                    .in("s", "task", "always")
                    .out("task", "work", "take all task");
            Session s = sent(net, "A");
            long m = s.idOf("parent");
            answer(s, "Done", 0, "A");
            s.news("Other");
            assertThat(s.marking(m, "d")).isEqualTo("A");

            s.press("Open");

            assertThat(s.marking(m, "gate")).as("the visit has ended").isEqualTo("generic");
        }
    }

    @Test
    void returnsSurviveASnapshot() {
        NetBuilder net = gated(gated(parent(true), "out", "good", "d"), "too", "good", "e")
                .input("failed", "CheckReturn", value("bad"), Map.of())
                .in("sub", "failed", "always")
                .in("gate", "failed", "generic >= 2")
                .out("failed", "lost", "take all sub");
        Session s = sent(net, "A", "B");
        long m = s.idOf("parent");
        answer(s, "Failed", 1, "B");
        answer(s, "Done", 0, "A");
        s.replaceState(s.state().copy());

        s.press("Open");
        assertThat(s.marking(m, "d")).isEqualTo("A generic");
        s.replaceState(s.state().copy());
        s.press("Open");
        assertThat(s.fired()).as("one return, one occurrence").containsExactly("open");
        s.press("Open");

        assertThat(s.marking(m, "lost")).isEqualTo("B");
    }

    @Test
    void aRobotThatCameBackFromTwoVisitsIsAddedToAnEdgeOnceThoughItStandsInOneOnly() {
        Plan adding = new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .end("e")
                .input("over", "Interrupt", button("Over"), Map.of())
                .out("over", "e", "add all relevant")
                .build();
        NetBuilder net = parent(false)
                .transition("empty", "Other")
                .in("s", "empty", "generic >= 1")
                .out("empty", "sub", "take 1 generic")
                .transition("back")
                .in("sub", "back", "proxy >= 1")
                .out("back", "x", "take all sub");
        for (boolean emptyFirst : new boolean[] {true, false}) {
            Session s = new Session(net.build(), adding);
            long m = s.join("A").start("parent");
            s.news(emptyFirst ? "Other" : "News", emptyFirst ? new String[0] : new String[] {"A"});
            s.news(emptyFirst ? "News" : "Other", emptyFirst ? new String[] {"A"} : new String[0]);
            long withoutRobot = s.activations("c").get(emptyFirst ? 0 : 1).mission();
            long withRobot = s.activations("c").get(emptyFirst ? 1 : 0).mission();

            s.step(new Input.Interrupt(withoutRobot, "Over", List.of("A")));
            s.step(new Input.Interrupt(withRobot, "Over", List.of("A")));

            assertThat(s.fired()).containsExactly("over", "back");
            assertThat(s.marking(m)).isEqualTo(Map.of("sub", "generic", "x", "A"));
        }
    }

    @Test
    void aStaticInstanceReturnsWhenTheSubMissionsOfThatFiringHaveStarted() {
        Plan inner = new NetBuilder("inner")
                .start("i")
                .transition("work")
                .in("i", "work", "proxy >= 1")
                .out("work", "j", "take all proxy")
                .build();
        Plan child = new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .end("e")
                .sub("w", "inner")
                .transition("over", "Done")
                .in("c", "over", "relevant all")
                .out("over", "e", "take all relevant")
                .out("over", "w", "add all relevant")
                .build();
        NetBuilder net =
                parent(true).transition("back").in("sub", "back", "proxy >= 1").out("back", "x", "take all sub");
        Session s = new Session(net.build(), child, inner);
        long m = s.join("A").start("parent");
        s.news("News", "A");

        s.answer("Done", "c", "A");

        assertThat(s.fired()).containsExactly("over", "work", "back");
        assertThat(s.marking(m, "x")).isEqualTo("A");
    }
}
