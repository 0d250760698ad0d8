package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.ValueType;

/** Occurrences and what waits (R-OCC-*, R-PEND-*). */
class InputEventRulesTest {
    private static NetBuilder gate(boolean all) {
        NetBuilder net = new NetBuilder("net")
                .start("s")
                .output("work", "Do")
                .transition("begin", "News")
                .in("s", "begin", "relevant all")
                .out("begin", "work", "take all relevant")
                .transition("open", "Other")
                .in("s", "open", "generic >= 1")
                .out("open", "gate", "take 1 generic")
                .transition("t", "Done")
                .in("work", "t", "relevant all")
                .in("gate", "t", "generic >= 1")
                .out("t", "x", "take all relevant");
        return all ? net.waitForAll("t") : net;
    }

    @Test
    void answersAreKeptInOrderAndUsedOneByOne() {
        Session s = new Session(gate(false).build());
        long m = s.join("A", "B").start("net");
        s.news("News", "A", "B");

        s.answer("Done", "work", "B");
        s.answer("Done", "work", "A");
        assertThat(s.fired()).isEmpty();
        s.news("Other");

        assertThat(s.fired()).containsExactly("open", "t", "t");
        assertThat(s.marking(m, "x")).isEqualTo("B A");
    }

    @Test
    void waitForAllFiresOnceWhenEverybodyHasReported() {
        Session s = new Session(gate(true).build());
        long m = s.join("A", "B", "C").start("net");
        s.news("Other");
        s.news("News", "A", "B", "C");

        s.answer("Done", "work", "B");
        s.answer("Done", "work", "B");
        s.answer("Done", "work", "C");
        assertThat(s.view().whyNotEnabled(m, "t").reasons()).anyMatch(r -> r.contains("not yet reported: A"));
        s.answer("Done", "work", "A");

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.marking(m, "x")).isEqualTo("A B C");
    }

    @Test
    void waitForAllNeverFiresForNobodyAndARobotThatLeftReportsAgain() {
        Session s = new Session(gate(true)
                .transition("back", "Done2")
                .in("work", "back", "relevant all")
                .out("back", "work", "take all relevant")
                .transition("away", "Failed")
                .in("work", "away", "relevant all")
                .out("away", "x", "take all relevant")
                .build());
        long m = s.join("A", "B").start("net");
        s.news("Other");
        assertThat(s.allFired()).containsExactly("open");
        s.news("News", "A", "B");
        Activation first = s.latest("work");
        s.answer("Done", first, "A");

        s.answer("Done2", first, "A");
        assertThat(s.notes()).contains(NoteKind.DISCARDED);
        s.answer("Done", first, "B");
        assertThat(s.fired()).isEmpty();
        s.answer("Failed", first, "B");
        assertThat(s.fired()).containsExactly("away");
        s.answer("Done", "work", "A");

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.marking(m, "x")).isEqualTo("B A");
    }

    @Test
    void newerNewsReplacesOlderOfTheSameNames() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .variable("@v", ValueType.Simple.INTEGER)
                .input("t", "News", Map.of(), Map.of("value", "@v"))
                .in("s", "t", "relevant all")
                .in("gate", "t", "generic >= 1")
                .out("t", "x", "add 1 generic")
                .transition("open", "Other")
                .in("s", "open", "always")
                .out("open", "gate", "take 1 generic")
                .build());
        long m = s.join("A").start("net");
        for (int i = 1; i <= 3; i++) {
            s.step(new Input.Received(Occurrence.news("News", List.of("A"), Map.of("value", new IntegerValue(i)))));
        }

        s.news("Other");

        assertThat(s.fired()).containsExactly("open", "t");
        assertThat(s.view().variable(m, "@v")).contains(new IntegerValue(3));
    }

    @Test
    void severalInputEventsMustNameTheSameAndThoseThatNameNoneJoinWithAny() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Do")
                .transition("t", "Done", "News", "Other")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        long m = s.join("A", "B").start("net");

        s.answer("Done", "s", "A");
        s.news("News", "B");
        s.news("Other");
        assertThat(s.allFired()).isEmpty();
        assertThat(s.view().whyNotEnabled(m, "t").yes()).isFalse();
        s.news("News", "A");

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.marking(m, "x")).isEqualTo("A");
    }

    @Test
    void anAnswerNamingNobodyWhereTokensWereAskedForIsReportedAndTheQuestionStaysOpen() {
        Session s = new Session(gate(false).build());
        s.join("A").start("net");
        s.news("Other");
        s.news("News", "A");

        s.answer("Done", "work");
        assertThat(s.notes()).containsExactly(NoteKind.NAMES_NOBODY);
        assertThat(s.view().openActivations()).hasSize(1);
        s.answer("Done", "work", "A");

        assertThat(s.fired()).containsExactly("t");
    }

    @Test
    void anAnswerNamingNobodyToAVisitThatHasEndedIsLate() {
        Session s = new Session(new NetBuilder("net")
                .start("b")
                .transition("begin")
                .in("b", "begin", "proxy >= 1")
                .out("begin", "s", "take all proxy")
                .output("s", "Do")
                .transition("move", "News")
                .in("s", "move", "relevant all")
                .out("move", "other", "take all relevant")
                .transition("t", "Done")
                .in("s", "t", "always")
                .in("other", "t", "always")
                .out("t", "x", "take all relevant")
                .build());
        s.join("A").start("net");
        s.answer("Done", "s");
        assertThat(s.notes()).containsExactly(NoteKind.NAMES_NOBODY);
        s.news("News", "A");

        s.answer("Done", "s");

        assertThat(s.notes()).containsExactly(NoteKind.LATE);
    }

    @Test
    void anAnswerAboutARobotThatWentToAnotherInPlaceIsStillForTheTransition() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Do")
                .transition("move", "News")
                .in("s", "move", "relevant all")
                .out("move", "other", "take all relevant")
                .transition("t", "Done")
                .in("s", "t", "always")
                .in("other", "t", "always")
                .out("t", "x", "take all relevant")
                .build());
        long m = s.join("A").start("net");
        Activation asked = s.latest("s");
        s.news("News", "A");

        s.answer("Done", asked, "A");

        assertThat(s.marking(m, "x")).isEqualTo("A");
    }

    @Test
    void anActivationWithoutMissionIsAnAnswerInTheMissionThatAskedAndNewsInOthers() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Do")
                .transition("t", "News")
                .in("s", "t", "generic >= 1")
                .out("t", "x", "add all relevant")
                .build());
        long asking = s.start("net");
        long other = s.start("net");
        Activation asked = s.activations("s").get(0);

        s.step(new Input.Received(new Occurrence("News", 0, asked.id(), List.of("A"), List.of(), Map.of())));

        assertThat(s.marking(asking, "x")).isEqualTo("A");
        assertThat(s.marking(other, "x")).isEqualTo("A");
    }

    @Test
    void nothingIsDroppedSilentlyAndFrequentNewsIsCounted() {
        Session s = new Session(gate(false).build());
        s.join("A").start("net");

        s.news("Done2", "A");
        assertThat(s.notes()).containsExactly(NoteKind.DISCARDED);
        s.news("Pose", "A");

        assertThat(s.notes()).isEmpty();
        assertThat(s.state().net.discardedNews.all()).containsEntry("Pose", 1L);
    }

    @Test
    void aBurstOfAThousandEventsLosesNone() {
        Session s = new Session(gate(false).build());
        String[] robots = new String[1000];
        for (int i = 0; i < robots.length; i++) {
            robots[i] = "R" + i;
        }
        long m = s.join(robots).start("net");
        s.news("News", robots);
        Activation asked = s.latest("work");
        for (String robot : robots) {
            s.answer("Done", asked, robot);
        }

        s.news("Other");

        assertThat(s.fired()).hasSize(1001);
        assertThat(s.view().mission(m).orElseThrow().marking().get("x")).hasSize(1000);
    }

    @Test
    void anEventNamingRobotAndTaskFiresOnce() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .task("T", "Measure", Map.of())
                .output("s", "Do")
                .transition("t", "Done")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        long m = s.join("A").start("net");
        s.step(new Input.AllocateTasks(Map.of(new TaskId(m, "T"), java.util.Optional.of("A"))));

        s.step(new Input.Received(
                Occurrence.answer("Done", s.latest("s"), List.of("A"), List.of(new TaskId(m, "T")), Map.of())));

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.marking(m, "x")).isEqualTo("#T");
    }

    @Test
    void aRobotsCurrentTaskOfTheAnsweredActivationIsRelevant() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .task("T", "Measure", Map.of())
                .output("work", "Do")
                .transition("begin")
                .in("s", "begin", "task >= 1")
                .out("begin", "work", "take all task")
                .transition("t", "Done")
                .in("work", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        long m = s.join("A").start("net");
        s.answer("Done", "work", "A");
        assertThat(s.fired()).isEmpty();
        s.step(new Input.AllocateTasks(Map.of(new TaskId(m, "T"), java.util.Optional.of("A"))));

        s.answer("Done", "work", "A");

        assertThat(s.marking(m, "x")).isEqualTo("#T");
    }

    @Test
    void aReceivedAnswerDoesNotSurviveLeavingThePlace() {
        Session s = new Session(gate(false)
                .transition("again", "Done2")
                .in("work", "again", "relevant all")
                .out("again", "work", "take all relevant")
                .build());
        s.join("A").start("net");
        s.news("News", "A");
        s.answer("Done", "work", "A");

        s.answer("Done2", "work", "A");
        assertThat(s.notes()).contains(NoteKind.DISCARDED);
        s.news("Other");

        assertThat(s.fired()).containsExactly("open");
    }

    @Test
    void timersEndWithTheirVisitAndPerRobotWithTheRobot() {
        Map<String, org.sami.spn.model.FieldSource> second = Map.of(
                "duration", new org.sami.spn.model.FieldSource.Fixed(new org.sami.spn.value.DurationValue(1000)));
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "StartProxyTimer", second, Map.of())
                .transition("leave", "News")
                .in("s", "leave", "relevant all")
                .out("leave", "x", "take all relevant")
                .transition("t", "ProxyTimerExpired")
                .in("s", "t", "relevant all")
                .out("t", "y", "take all relevant")
                .build());
        long m = s.join("A", "B").start("net");
        assertThat(s.view().nextDueMillis()).hasValue(1000);
        s.news("News", "A");

        s.advance(1000);

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.marking(m, "y")).isEqualTo("B");
        assertThat(s.view().nextDueMillis()).isEmpty();
        assertThat(s.last()).noneMatch(Effect.Noted.class::isInstance);
    }

    /** R-PEND-4. The aborted child had no token, so its Sub-mission Aborted names nobody. */
    @Test
    void anAbortedChildsAnswerThatNamesNobodyIsDiscardedWithItsVisitAndNoted() {
        Plan child = new NetBuilder("child")
                .start("c")
                .end("e")
                .transition("over", "News")
                .in("c", "over", "always")
                .out("over", "e", "always")
                .build();
        Plan parent = new NetBuilder("parent")
                .start("s")
                .transition("send")
                .in("s", "send", "generic >= 1")
                .out("send", "sub", "always")
                .out("send", "rest", "take all generic")
                .sub("sub", "child")
                .transition("back", "SubMissionAborted")
                .in("sub", "back", "always")
                .out("back", "after", "always")
                .transition("gated", "SubMissionAborted")
                .in("sub", "gated", "always")
                .in("gate", "gated", "generic >= 1")
                .out("gated", "other", "always")
                .build();
        Session s = new Session(parent, child);
        s.start("parent");

        s.step(new Input.AbortMission(s.idOf("child")));

        assertThat(s.fired()).containsExactly("back");
        assertThat(s.notes()).containsExactly(NoteKind.DISCARDED);
    }
}
