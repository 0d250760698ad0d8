package org.sami.spn.statespace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** What deep checks find on small plans whose states can be counted by hand. */
class DeepCheckTest {
    private static final List<String> ROBOTS = List.of("A", "B");

    /** The operator says yes or no; who says no is left standing unless there is a way out. */
    private static NetBuilder asking() {
        return new NetBuilder("asks")
                .start("ask")
                .output("ask", "Approve")
                .end("end")
                .transition("yes", "Yes")
                .in("ask", "yes", "any >= 1")
                .out("yes", "end", "take all any")
                .transition("no", "No")
                .in("ask", "no", "any >= 1")
                .out("no", "waiting", "take all any");
    }

    private static NetBuilder withWayOut() {
        return asking().in("waiting", "again", "any >= 1").out("again", "end", "take all any");
    }

    private static DeepRequest request(Plan plan, int mostStates) {
        return new DeepRequest(NetBuilder.project(plan), TestVocabulary.TEST, plan.id(), ROBOTS, mostStates);
    }

    @Test
    void stateFromWhichNoEndIsReachedComesWithTheShortestWayThere() {
        Plan plan = asking().build();

        DeepResult result = new StuckStates().run(request(plan, 100), SearchWatch.NONE);

        assertThat(result.complete()).isTrue();
        assertThat(result.findings()).singleElement().satisfies(found -> {
            Finding finding = found.finding();
            assertThat(finding.code()).isEqualTo("W-STUCK");
            assertThat(finding.plan()).isEqualTo("asks");
            assertThat(finding.elements()).containsExactly("waiting");
            assertThat(finding.message()).contains("can end no more", "waiting", "1 step", "2 robots");
            TestCase witness = found.witness().orElseThrow();
            assertThat(witness.proxies()).isEqualTo(ROBOTS);
            assertThat(witness.steps())
                    .containsExactly(new TestStep.Answer("ask.Approve", new TestStep.Reply.YesNo(false)));
            Stepper played =
                    Stepper.startAs(new Engine(TestVocabulary.TEST, NetBuilder.project(plan)), "asks", witness);
            witness.steps()
                    .forEach(step -> assertThat(played.take(step).refusal()).isEmpty());
            assertThat(played.view().mission(played.mission()).orElseThrow().marking())
                    .containsOnlyKeys("waiting");
            assertThat(played.outcome()).isEmpty();
        });
    }

    @Test
    void planThatCanAlwaysEndHasNoStuckState() {
        DeepResult result = new StuckStates().run(request(withWayOut().build(), 100), SearchWatch.NONE);

        assertThat(result.findings()).isEmpty();
        assertThat(result.complete()).isTrue();
        assertThat(result.summary())
                .isEqualTo("All 2 states with 2 robots were looked at: from each of them the mission can still end");
    }

    @Test
    void ringThatGoesOnForEverIsStuckToo() {
        Plan plan = asking().output("waiting", "Do")
                .transition("done", "Done")
                .in("waiting", "done", "any >= 1")
                .out("done", "waiting", "take all any")
                .build();

        assertThat(new StuckStates().run(request(plan, 100), SearchWatch.NONE).findings())
                .isNotEmpty()
                .allSatisfy(found -> assertThat(found.finding().elements()).containsExactly("waiting"));
    }

    @Test
    void stateBeyondTheBoundIsNotCalledStuck() {
        DeepResult result = new StuckStates().run(request(asking().build(), 1), SearchWatch.NONE);

        assertThat(result.complete()).isFalse();
        assertThat(result.findings()).isEmpty();
        assertThat(result.summary()).startsWith("Of the first 1 states").endsWith("not looked at");
    }

    @Test
    void placeThatNobodyEntersIsAWarningOnlyWhereAllWasLookedAt() {
        Plan plan = asking().in("ask", "both", "any >= 9")
                .in("waiting", "both", "any >= 1")
                .out("both", "treasure", "take all any")
                .build();

        DeepResult all = new NeverReached().run(request(plan, 100), SearchWatch.NONE);
        assertThat(all.findings())
                .extracting(
                        found -> found.finding().code() + " " + found.finding().elements())
                .containsExactlyInAnyOrder("W-NEVER-REACHED [treasure]", "W-NEVER-REACHED [both]");
        assertThat(all.findings())
                .allSatisfy(found -> assertThat(found.witness()).isEmpty());

        DeepResult some = new NeverReached().run(request(plan, 1), SearchWatch.NONE);
        assertThat(some.findings())
                .isNotEmpty()
                .allSatisfy(found -> assertThat(found.finding().code()).isEqualTo("N-NOT-REACHED"));

        assertThat(new NeverReached()
                        .run(request(withWayOut().build(), 100), SearchWatch.NONE)
                        .findings())
                .isEmpty();
    }

    @Test
    void searchStopsWhenItIsToldToAndSaysHowFarItCame() {
        List<Integer> told = new ArrayList<>();
        SearchWatch stopped = new SearchWatch() {
            @Override
            public void looked(int states, int waiting) {
                told.add(states);
            }

            @Override
            public boolean isCancelled() {
                return true;
            }
        };

        DeepResult result = new StuckStates().run(request(asking().build(), 100), stopped);

        assertThat(result.states()).isZero();
        assertThat(result.complete()).isFalse();
        assertThat(told).containsExactly(0);
    }

    /** A robot says again and again that it is done, and each time there is one token more. */
    private static NetBuilder piling() {
        return new NetBuilder("piles")
                .start("work")
                .output("work", "Do")
                .end("end")
                .transition("more", "Done")
                .in("work", "more", "any >= 1")
                .out("more", "heap", "add 1 generic")
                .transition("over", "Failed")
                .in("work", "over", "any >= 1")
                .out("over", "end", "take all any");
    }

    @Test
    void tokensThatPileUpWithoutBoundAreFoundWithARunThatShowsThem() {
        DeepResult result = DeepChecks.ALL.get(0).run(request(piling().build(), 1_000_000), SearchWatch.NONE);

        assertThat(result.states()).isLessThan(100);
        assertThat(result.complete()).isFalse();
        assertThat(result.summary()).contains("tokens pile up", "were not followed further");
        assertThat(result.findings())
                .filteredOn(found -> found.finding().code().equals("W-PILES-UP"))
                .singleElement()
                .satisfies(found -> {
                    assertThat(found.finding().elements()).containsExactly("heap");
                    assertThat(found.witness().orElseThrow().steps()).hasSizeGreaterThanOrEqualTo(2);
                });
    }

    @Test
    void heapThatIsTakenAwayAtLastIsNone() {
        Plan plan = piling().in("heap", "away", "generic >= 4")
                .out("away", "end", "take all any")
                .build();

        assertThat(DeepChecks.ALL
                        .get(0)
                        .run(request(plan, 1_000), SearchWatch.NONE)
                        .findings())
                .isEmpty();
    }

    @Test
    void heapThatGrowsUntilATimerRunsDownIsNone() {
        NetBuilder growing = new NetBuilder("timed")
                .start("s")
                .output("s", "StartTimer", duration(2_000), Map.of())
                .transition("round", "TimerExpired")
                .in("s", "round", "always")
                .out("round", "s", "always")
                .out("round", "heap", "add 1 generic");

        assertThat(codes(growing.build())).contains("W-PILES-UP");
        Plan timed = growing.output("heap", "StartTimer", duration(20_000), Map.of())
                .end("end")
                .transition("over", "TimerExpired")
                .in("heap", "over", "always")
                .out("over", "end", "take all any")
                .build();
        assertThat(codes(timed)).isEmpty();
    }

    private static Map<String, FieldSource> duration(long millis) {
        return Map.of("duration", new FieldSource.Fixed(new DurationValue(millis)));
    }

    private static List<String> codes(Plan plan) {
        return new TokensPileUp()
                .run(request(plan, 1_000), SearchWatch.NONE).findings().stream()
                        .map(found -> found.finding().code())
                        .toList();
    }

    @Test
    void searchEndsWhenItsMemoryIsUsedUp() {
        DeepRequest small = new DeepRequest(
                NetBuilder.project(withWayOut().build()), TestVocabulary.TEST, "asks", ROBOTS, List.of(1), 1_000, 1);

        DeepResult result = new StuckStates().run(small, SearchWatch.NONE);

        assertThat(result.complete()).isFalse();
        assertThat(result.findings()).isEmpty();
        assertThat(result.summary()).endsWith("the memory for more is used up");
    }

    @Test
    void whatCannotBeMadeUpIsSaidAndNotCalledStuck() {
        Plan plan = new NetBuilder("asks")
                .variable("@x", ValueType.Simple.PLAN)
                .start("ask")
                .output(
                        "ask",
                        "Redefine",
                        Map.of("variable", new FieldSource.Fixed(new VariableReference("@x"))),
                        Map.of())
                .end("end")
                .transition("given", "Redefined")
                .in("ask", "given", "any >= 1")
                .out("given", "end", "take all any")
                .build();

        DeepResult result = new StuckStates().run(request(plan, 100), SearchWatch.NONE);

        assertThat(result.findings()).isEmpty();
        assertThat(result.summary()).contains("not looked at: the operator is asked for @x");
    }

    // ---- States that are like one another

    /** Robots go on one after the other, each by news of it; the mission ends when both are there. */
    private static NetBuilder oneByOne() {
        return new NetBuilder("one-by-one")
                .start("s")
                .end("end")
                .transition("heard", "Pose")
                .in("s", "heard", "relevant all")
                .out("heard", "there", "take all relevant")
                .transition("both")
                .in("there", "both", "proxy >= 2")
                .out("both", "end", "take all any");
    }

    private static int states(Plan plan) {
        DeepResult result = new StuckStates().run(request(plan, 1_000), SearchWatch.NONE);
        assertThat(result.complete()).isTrue();
        assertThat(result.findings()).isEmpty();
        return result.states();
    }

    @Test
    void robotsThatNobodyTellsApartAreExchanged() {
        assertThat(states(oneByOne().build()))
                .as("both at the start, one of them there, the end")
                .isEqualTo(3);
    }

    @Test
    void robotsOfWhichAPlanSpeaksAreNotExchanged() {
        NetBuilder naming = oneByOne().variable("@who", ValueType.Simple.PROXY, new ProxyValue("A"));

        assertThat(states(naming.build()))
                .as("A there and B there are two states")
                .isEqualTo(4);
    }

    @Test
    void timerThatIsStartedAnewForEverHidesNoneThatRunsLonger() {
        Plan plan = new NetBuilder("timers")
                .start("s")
                .end("end")
                .transition("fork")
                .in("s", "fork", "generic >= 1")
                .out("fork", "short", "take 1 generic")
                .out("fork", "long", "add 1 generic")
                .output(
                        "short",
                        "StartTimer",
                        Map.of("duration", new FieldSource.Fixed(new DurationValue(7_000))),
                        Map.of())
                .output(
                        "long",
                        "StartTimer",
                        Map.of("duration", new FieldSource.Fixed(new DurationValue(60_000))),
                        Map.of())
                .transition("again", "TimerExpired")
                .in("short", "again", "generic >= 1")
                .out("again", "short", "take 1 generic")
                .transition("over", "TimerExpired")
                .in("long", "over", "generic >= 1")
                .out("over", "end", "take all any")
                .build();

        assertThat(states(plan)).isLessThan(5);
    }

    // ---- Dropped robots

    @Test
    void missionThatWaitsForADroppedRobotIsNotedWithARunThatShowsIt() {
        Plan plan = oneByOne().build();

        DeepResult result = new StuckAfterDrop().run(request(plan, 100), SearchWatch.NONE);

        assertThat(result.findings()).singleElement().satisfies(found -> {
            assertThat(found.finding().code()).isEqualTo("N-STUCK-AFTER-DROP");
            assertThat(found.finding().severity()).isEqualTo(Severity.NOTE);
            assertThat(found.finding().elements()).containsExactly("s", "there");
            TestCase witness = found.witness().orElseThrow();
            assertThat(witness.steps())
                    .filteredOn(TestStep.Drop.class::isInstance)
                    .hasSize(1);
            Stepper played =
                    Stepper.startAs(new Engine(TestVocabulary.TEST, NetBuilder.project(plan)), plan.id(), witness);
            witness.steps()
                    .forEach(step -> assertThat(played.take(step).refusal()).isEmpty());
            assertThat(played.outcome()).isEmpty();
        });
        assertThat(result.summary()).contains("a robot dropped at each of them leads to", "wait for it forever");
        assertThat(new StuckStates().run(request(plan, 100), SearchWatch.NONE).findings())
                .isEmpty();
    }

    @Test
    void missionThatGoesOnWithWhoIsLeftIsNotNoted() {
        Plan plan = new NetBuilder("goes-on")
                .start("s")
                .end("end")
                .transition("heard", "Pose")
                .in("s", "heard", "relevant all")
                .out("heard", "there", "take all relevant")
                .transition("all")
                .in("there", "all", "proxy >= 1")
                .in("s", "all", "proxy = 0")
                .out("all", "end", "take all any")
                .build();

        DeepResult result = DeepChecks.ALL.get(0).run(request(plan, 100), SearchWatch.NONE);

        assertThat(result.findings()).isEmpty();
        assertThat(result.summary()).contains("a robot dropped at each of them leads to");
    }

    @Test
    void everyDeepCheckHasAnIdOfItsOwnAndSaysWhatItFinds() {
        assertThat(DeepChecks.ALL).extracting(DeepCheck::id).doesNotHaveDuplicates();
        assertThat(DeepChecks.ALL).allSatisfy(check -> {
            assertThat(check.id()).matches("[a-z]+(-[a-z]+)*");
            assertThat(check.help()).endsWith(".");
        });
    }
}
