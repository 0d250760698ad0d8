package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;

/** What a mission's outcome is (R-END-*). */
class OutcomeRulesTest {
    /** Draws its abort and its completion into end places; robots also end one by one when they are done. */
    private static NetBuilder child() {
        return new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .end("e", "home")
                .transition("over", "Done")
                .in("c", "over", "relevant all")
                .out("over", "e", "take all any")
                .transition("help", "AbortReceived")
                .in("c", "help", "always")
                .out("help", "home", "take all any")
                .transition("enough", "CompleteReceived")
                .in("c", "enough", "always")
                .out("enough", "e", "take all any");
    }

    private static NetBuilder parent() {
        return new NetBuilder("parent")
                .start("s")
                .sub("sub", "child")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "sub", "take all relevant")
                .transition("back")
                .in("sub", "back", "always")
                .out("back", "x", "take all sub");
    }

    private static NetBuilder rescue(NetBuilder parent) {
        return parent.transition("rescue", "SubMissionAborted")
                .in("sub", "rescue", "relevant all")
                .out("rescue", "lost", "take all relevant");
    }

    private static Session sent(Plan... plans) {
        Session s = new Session(plans);
        s.join("A", "B").start("parent");
        s.news("News", "A", "B");
        return s;
    }

    @Test
    void anAbortThatIsDrawnIntoAnEndPlaceEndsTheMissionAsAborted() {
        Session s = new Session(child().build());
        long m = s.join("A").start("child");

        s.step(new Input.AbortMission(m));

        assertThat(s.fired()).containsExactly("help");
        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
    }

    @Test
    void abortOfAllMissionsIsAskedOfEveryRoot() {
        Session s = new Session(child().build());
        long one = s.join("A").start("child");
        long two = s.start("child");

        s.step(new Input.AbortMission(Ids.NONE));

        assertThat(s.outcome(one)).contains(Outcome.ABORTED);
        assertThat(s.outcome(two)).contains(Outcome.ABORTED);
    }

    @Test
    void theParentOfAChildThatDrewItsAbortIsToldOfTheAbort() {
        Session s = sent(rescue(parent()).build(), child().build());
        long m = s.idOf("parent");
        long child = s.idOf("child");

        s.step(new Input.AbortMission(child));

        assertThat(s.fired()).containsExactly("help", "rescue");
        assertThat(s.outcome(child)).contains(Outcome.ABORTED);
        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "lost", "A B"));
    }

    @Test
    void whereNoTransitionWaitsForAnAbortThatWasDrawnTheOperatorDecides() {
        Session s = sent(parent().build(), child().build());
        long m = s.idOf("parent");

        s.step(new Input.AbortMission(s.idOf("child")));
        assertThat(s.marking(m, "sub")).isEqualTo("A B");
        s.decide(new Answer.YesNo(true));

        assertThat(s.marking(m, "x")).isEqualTo("A B");
    }

    @Test
    void aMissionThatGoesOnAfterAnAbortIsAbortedWhenItEnds() {
        Plan slow = new NetBuilder("net")
                .start("s")
                .output("back", "Do")
                .end("e")
                .transition("help", "AbortReceived")
                .in("s", "help", "always")
                .out("help", "back", "take all proxy")
                .transition("home", "Done")
                .in("back", "home", "relevant all")
                .out("home", "e", "take all relevant")
                .build();
        Session s = new Session(slow);
        long m = s.join("A").start("net");
        s.step(new Input.AbortMission(m));
        assertThat(s.outcome(m)).isEmpty();
        s.replaceState(s.state().copy());

        s.answer("Done", "back", "A");

        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
    }

    @Test
    void anAbortMissionOnAnEndPlaceMakesTheOutcomeAborted() {
        NetBuilder aborting = child().output("e", "AbortMission");
        Session root = new Session(aborting.build());
        long m = root.join("A").start("child");
        root.answer("Done", "c", "A");
        assertThat(root.outcome(m)).contains(Outcome.ABORTED);

        Session s = sent(rescue(parent()).build(), aborting.build());
        s.answer("Done", "c", "A", "B");

        assertThat(s.fired()).containsExactly("over", "rescue");
        assertThat(s.marking(s.idOf("parent"), "lost")).isEqualTo("A B");
    }

    @Test
    void anAbortMissionOnTheWayCountsThoughTheEndPlaceComesFirst() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "AbortMission")
                .end("e")
                .transition("t")
                .in("s", "t", "always")
                .out("t", "e", "take all any")
                .build());
        long m = s.start("net");

        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
    }

    @Test
    void aCompletionThatIsDrawnIntoAnEndPlaceIsACompletion() {
        Session s = sent(parent().build(), child().build());
        long child = s.idOf("child");

        s.step(new Input.CompleteMission(child));

        assertThat(s.fired()).containsExactly("enough", "back");
        assertThat(s.outcome(child)).contains(Outcome.COMPLETED);
        assertThat(s.marking(s.idOf("parent"), "x")).isEqualTo("A B");
    }

    @Test
    void anAbortIsStrongerThanACompletionWhicheverWasAskedFirst() {
        for (boolean abortFirst : new boolean[] {true, false}) {
            Session s = new Session(new NetBuilder("net")
                    .start("s")
                    .transition("a", "AbortReceived")
                    .in("s", "a", "always")
                    .out("a", "x", "add 1 generic")
                    .transition("c", "CompleteReceived")
                    .in("s", "c", "always")
                    .out("c", "x", "add 1 generic")
                    .end("e")
                    .transition("t", "News")
                    .in("s", "t", "always")
                    .out("t", "e", "take all any")
                    .build());
            long m = s.start("net");
            Input abort = new Input.AbortMission(m);
            Input completion = new Input.CompleteMission(m);
            s.step(abortFirst ? abort : completion);
            s.step(abortFirst ? completion : abort);
            assertThat(s.allFired()).containsExactlyInAnyOrder("a", "c");

            s.news("News");

            assertThat(s.outcome(m)).contains(Outcome.ABORTED);
        }
    }

    @Test
    void aChildThatWasAbortedReturnsNoValue() {
        Plan telling = child().output(
                        "home", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("good"))), Map.of())
                .build();
        NetBuilder net = parent().input("check", "CheckReturn", Map.of("value", new TextValue("good")), Map.of());
        Session s = sent(
                net.in("sub", "check", "always")
                        .out("check", "y", "take all sub")
                        .build(),
                telling);

        s.step(new Input.AbortMission(s.idOf("child")));
        s.decide(new Answer.YesNo(true));

        assertThat(s.allFired()).contains("back").doesNotContain("check");
    }
}
