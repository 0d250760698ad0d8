package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;

/** The main job, whole: plans of the library on simulated boats. */
@Tag("long")
class VisitRunTest {
    @ParameterizedTest
    @CsvSource({"3,20", "3,30", "5,20", "5,30"})
    void cooperativeLocationVisitEndsWithAllLocationsVisited(int boats, int locations) {
        RunPlan plan = TestRuns.plan("clv");

        RunReport report = TestRuns.run(plan, TestRuns.settings(plan, boats, locations, 1));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(locations).allMatch(LocationResult::visited);
        assertThat(report.boats()).hasSize(boats).allSatisfy(boat -> {
            assertThat(boat.distanceM()).isPositive();
            assertThat(boat.batteryPercent()).isBetween(1.0, 99.9);
        });
        assertThat(report.notes()).noneMatch(note -> note.kind().equals("handler_failed"));
    }

    @Test
    void clicksAreThoseOfTheTable() {
        RunPlan plan = TestRuns.plan("clv");

        RunReport report = TestRuns.run(plan, TestRuns.settings(plan, 3, 20, 1));

        // start 1, three boats and their confirmation 4, twenty locations and theirs 21, the allocation 1
        assertThat(report.result().clicks()).isEqualTo(27);
    }

    @Test
    void equalSeedsGiveEqualRunsAtAnySpeed() {
        RunPlan plan = TestRuns.plan("clv");
        RunSettings settings = TestRuns.settings(plan, 3, 12, 5);
        FakePacer pacer = new FakePacer();

        RunReport fast = TestRuns.run(plan, settings);
        RunReport again = TestRuns.run(plan, settings);
        RunReport paced = new InProcessRun(plan, settings.withSpeed(new Speed(3)), AnswersFile.EMPTY, RunJournal.none())
                .run(pacer, RunObserver.NONE);

        assertThat(again.result().runHash()).isEqualTo(fast.result().runHash());
        assertThat(paced.result().runHash()).isEqualTo(fast.result().runHash());
        assertThat(paced.result().simulatedMillis()).isEqualTo(fast.result().simulatedMillis());
        assertThat(pacer.turns).hasSizeGreaterThan(1000).isSorted();
    }

    @Test
    void boatsTickedOnSeveralThreadsMakeTheSameRun() {
        RunPlan plan = TestRuns.plan("explore-area");
        RunSettings settings = RunSettings.of(
                        plan.plan().id(),
                        plan.plan().id(),
                        new FleetSettings(24, 1, 120, 3).on(NamedConditions.FIELD.conditions()))
                .limitMillis(150_000)
                .parameters(Map.of("@spacing", "6"))
                .build();
        InProcessRun helped = new InProcessRun(plan, settings, AnswersFile.EMPTY, RunJournal.none());
        helped.useHelpers(3);

        RunReport alone = TestRuns.run(plan, settings);
        RunReport together = helped.run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(together.result().runHash()).isEqualTo(alone.result().runHash());
        assertThat(together.boats()).isEqualTo(alone.boats());
    }

    @Test
    void runsSideBySideAreTheRunsThatTheyAreAlone() throws Exception {
        RunPlan plan = TestRuns.plan("clv");
        List<Callable<String>> runs = new ArrayList<>();
        for (long seed = 1; seed <= 6; seed++) {
            RunSettings settings = TestRuns.settings(plan, 4, 12, seed);
            runs.add(() -> TestRuns.run(plan, settings).result().runHash());
        }
        List<String> alone = new ArrayList<>();
        for (Callable<String> run : runs) {
            alone.add(run.call());
        }
        ExecutorService threads = Executors.newFixedThreadPool(runs.size());
        try {
            List<String> together = new ArrayList<>();
            for (Future<String> run : threads.invokeAll(runs)) {
                together.add(run.get());
            }

            assertThat(together).isEqualTo(alone).doesNotHaveDuplicates();
        } finally {
            threads.shutdownNow();
        }
    }

    @Test
    void anotherSeedGivesAnotherRun() {
        RunPlan plan = TestRuns.plan("clv");

        String first =
                TestRuns.run(plan, TestRuns.settings(plan, 3, 12, 5)).result().runHash();
        String second =
                TestRuns.run(plan, TestRuns.settings(plan, 3, 12, 6)).result().runHash();

        assertThat(first).matches("[0-9a-f]{64}").isNotEqualTo(second);
    }

    @Test
    void stationKeepingEnds() {
        RunPlan plan = TestRuns.plan("station-keep");

        RunReport report = TestRuns.run(plan, TestRuns.settings(plan, 3, 1, 1));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats())
                .allSatisfy(boat -> assertThat(boat.distanceM()).isGreaterThan(50));
    }

    @Test
    void sampleWithSubMissionsEnds() {
        RunReport report = new InProcessRun(
                        TestRuns.sample(), TestRuns.sampleSettings(), TestRuns.sampleAnswers(), RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(15); // five of them belong to the allocation that is rejected
        assertThat(report.locationsVisited()).isGreaterThanOrEqualTo(10);
        assertThat(report.firings()).extracting(f -> f.plan()).contains("sample", "leg");
    }

    @Test
    void stopsAtTheSetTime() {
        RunPlan plan = TestRuns.plan("clv");
        RunSettings settings = TestRuns.settings(plan, 3, 12, 5).withLimit(java.util.OptionalLong.of(100_050));

        RunReport report = TestRuns.run(plan, settings);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.RUNNING);
        assertThat(report.result().simulatedMillis()).isEqualTo(100_050);
    }

    @Test
    void stopsWhenItIsAskedTo() {
        RunPlan plan = TestRuns.plan("clv");
        int[] asked = {0};
        RunObserver impatient = new RunObserver(progress -> {}, () -> ++asked[0] > 500);

        RunReport report = new InProcessRun(
                        plan, TestRuns.settings(plan, 3, 12, 5), AnswersFile.EMPTY, RunJournal.none())
                .run(Pacer.UNPACED, impatient);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.RUNNING);
    }

    private static final class FakePacer implements Pacer {
        private final List<Long> turns = new ArrayList<>();

        @Override
        public void start(long virtualMillis) {
            turns.add(virtualMillis);
        }

        @Override
        public void awaitTurn(long virtualMillis) {
            turns.add(virtualMillis);
        }
    }
}
