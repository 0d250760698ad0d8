package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.TextValue;

/** "Why is this transition not enabled?" has an answer in words. */
class EnablingExplainerTest {
    private final Session s = new Session(new NetBuilder("net")
            .start("s")
            .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Stop")), Map.of())
            .in("x", "pull", "generic >= 2")
            .in("s", "pull", "proxy = 0")
            .transition("t", "News", "Other")
            .in("s", "t", "relevant all")
            .out("t", "x", "take all relevant")
            .transition("plain")
            .in("s", "plain", "generic >= 1")
            .in("x", "plain", "task < 1")
            .in("x", "plain", "generic == 1")
            .build());

    @Test
    void everyUnmetConditionIsNamedWithWhatIsThere() {
        long m = s.join("A", "B").start("net");

        assertThat(s.view().whyNotEnabled(m, "pull").reasons())
                .containsExactly(
                        "It waits for Interrupt 'Stop', which has not been received.",
                        "'x' must have at least 2 generic tokens; there are 0.",
                        "'s' must have no robots; there are 2.");
        assertThat(s.view().whyNotEnabled(m, "plain").reasons())
                .containsExactly("'x' must have exactly 1 generic tokens; there are 0.");
    }

    @Test
    void eventsThatDoNotFitTogetherAreNamed() {
        long m = s.join("A", "B").start("net");
        s.news("News", "A");
        s.news("Other", "B");

        assertThat(s.view().whyNotEnabled(m, "t").reasons())
                .containsExactly("The events that it has received do not name the same robots or tasks.");
    }

    @Test
    void missionsAndTransitionsThatAreNotThereAreNamed() {
        long m = s.start("net");

        assertThat(s.view().whyNotEnabled(99, "t").reasons()).containsExactly("Mission 99 is not running.");
        assertThat(s.view().whyNotEnabled(m, "no").reasons()).containsExactly("The plan 'net' has no transition 'no'.");
        s.step(new Input.AbortMission(m));
        assertThat(s.view().whyNotEnabled(m, "t").yes()).isFalse();
    }

    @Test
    void questionThatWasAnsweredIsNotWaitedFor() {
        Session asked = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Approve")
                .transition("yes", "Yes")
                .in("s", "yes", "proxy >= 1")
                .in("gate", "yes", "generic >= 1")
                .transition("no", "No")
                .in("s", "no", "proxy >= 1")
                .build());
        long m = asked.join("A").start("net");
        assertThat(asked.view().whyNotEnabled(m, "no").awaited())
                .extracting(InputEventSpec::type)
                .containsExactly("No");

        asked.decide(new Answer.YesNo(true));

        assertThat(asked.view().whyNotEnabled(m, "yes"))
                .isEqualTo(new EnablingExplanation(
                        false, List.of("'gate' must have at least 1 generic tokens; there are 0."), List.of()));
        assertThat(asked.view().whyNotEnabled(m, "no"))
                .isEqualTo(new EnablingExplanation(
                        false,
                        List.of("It waits for No, which can come no longer: what 's' asked has been answered."),
                        List.of()));
    }

    @Test
    void timerThatHasExpiredIsNotWaitedFor() {
        Session timed = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "StartTimer", Map.of("duration", new FieldSource.Fixed(new DurationValue(1000))), Map.of())
                .transition("t", "TimerExpired", "Other")
                .in("s", "t", "always")
                .build());
        long m = timed.join("A").start("net");
        timed.advance(1000);
        timed.news("Other");

        assertThat(timed.fired()).containsExactly("t");
        assertThat(timed.view().whyNotEnabled(m, "t").reasons())
                .contains("It waits for TimerExpired, which can come no longer: the timer of 's' has expired.");
    }

    @Test
    void subMissionThatHasEndedReturnsNothingMore() {
        Session helped = new Session(
                new NetBuilder("net")
                        .start("s")
                        .sub("s", "child")
                        .input("good", "CheckReturn", Map.of("value", new TextValue("good")), Map.of())
                        .in("s", "good", "always")
                        .build(),
                new NetBuilder("child")
                        .start("begin")
                        .end("over")
                        .transition("leave", "News")
                        .in("begin", "leave", "proxy >= 1")
                        .out("leave", "over", "take all any")
                        .build());
        long m = helped.join("A").start("net");
        assertThat(helped.missionOf("child").orElseThrow().place()).isEqualTo("s");
        assertThat(helped.view().whyNotEnabled(m, "good").awaited()).hasSize(1);

        helped.news("News", "A");

        assertThat(helped.view().whyNotEnabled(m, "good"))
                .isEqualTo(new EnablingExplanation(
                        false,
                        List.of("It waits for CheckReturn 'good', which can come no longer: "
                                + "the sub-mission on 's' is over."),
                        List.of()));
    }

    @Test
    void placeWithoutANameIsCalledByWhatItDoesAndNeverByItsId() {
        Plan plan = new NetBuilder("net")
                .start("p1")
                .output("p1", "Approve")
                .transition("t1")
                .in("p1", "t1", "proxy = 0")
                .build();
        Session unnamed = new Session(plan.withPlaces(
                plan.places().stream().map(place -> place.withName("")).toList()));
        long m = unnamed.join("A").start("net");

        assertThat(unnamed.view().whyNotEnabled(m, "t1").reasons())
                .containsExactly("The place of Approve must have no robots; there is 1.");
    }
}
