package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;

/** Areas are divided by how far charges last, so that no boat stops dead in its share: judged by true batteries and true tracks. */
@Tag("long")
class ExploredByChargeTest {
    static LongStream seeds() {
        return LongStream.rangeClosed(1, 20);
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void aBoatWithLittleChargeHasALittleShareAndTheOthersHaveTheRest(long seed) {
        RunReport report = run("explore-area", 400, 50, "35,100,70", Conditions.CALM, seed);

        assertThat(report.decisions()).extracting(DecisionResult::type).doesNotContain("LongWay");
        assertAllIsExplored(report, 99);
        assertAllMayComeHome(report);
    }

    /** Three full charges last for lanes of 50 m in 600 m, and not for the ways home. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void operatorIsAskedWhereChargesLastForTheAreaAndNotForTheWaysHome(long seed) {
        RunReport report = run("explore-area", 600, 50, "100,100,100", Conditions.FIELD, seed);

        assertThat(report.decisions())
                .filteredOn(decision -> decision.type().equals("LongWay"))
                .singleElement()
                .satisfies(question -> {
                    assertThat(question.prompt())
                            .matches("boat1 may not come home from the end of its way: \\d+ m there and \\d+ m back,"
                                    + " and its charge of 100 % is sure to last for 3182 m; boat2 .*; boat3 .*\\."
                                    + " Send them\\?");
                    assertThat(question.openedAtMillis()).isLessThan(15_000);
                });
        assertAllIsExplored(report, 97.5);
    }

    @Test
    void planThatKeepsWaysHomeLeavesWhatChargesDoNotLastForWithThem() {
        RunReport report = run(keepingHome(true), 600, 50, "100,100,100", Conditions.CALM, 1);

        assertThat(report.decisions())
                .filteredOn(decision -> decision.type().equals("LongWay"))
                .singleElement()
                .satisfies(question -> assertThat(question.prompt())
                        .matches("charges are sure to last for \\d\\d % of the area and the ways home: \\d+ m² stay"
                                + " unexplored, most near [0-9.,]+\\. Send them\\?"));
        Exploration explored = report.map().explorations().get(0);
        assertThat(explored.percent(explored.left().trueM2().orElseThrow())).isBetween(80.0, 95.0);
        assertAllMayComeHome(report);
    }

    @Test
    void planThatDoesNotKeepWaysHomeAsksNothing() {
        RunReport report = run(keepingHome(false), 600, 50, "100,100,100", Conditions.CALM, 1);

        assertThat(report.decisions()).extracting(DecisionResult::type).doesNotContain("LongWay");
        assertAllIsExplored(report, 99);
    }

    /** Lanes of 20 m take twice what three batteries last for. */
    @Test
    void operatorIsAskedBeforeTheStartWhatChargesDoNotLastForAndNoBoatStopsDead() {
        RunReport report = run("explore-area", 600, 20, "100,60,100", Conditions.CALM, 1);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.decisions())
                .filteredOn(decision -> decision.type().equals("LongWay"))
                .singleElement()
                .satisfies(question -> {
                    assertThat(question.prompt())
                            .matches("charges are sure to last for \\d\\d % of the area: \\d+ m² stay unexplored, most"
                                    + " near [0-9.,]+\\. Send them\\?");
                    assertThat(question.openedAtMillis()).isLessThan(15_000);
                });
        Exploration explored = report.map().explorations().get(0);
        assertThat(explored.uncoveredM2())
                .isCloseTo(explored.left().plannedM2().orElseThrow(), within(0.005 * explored.areaM2()));
        assertThat(explored.percent(explored.uncoveredM2())).isBetween(30.0, 60.0);
        assertNoBoatStoppedDead(report);
    }

    /** Its plan has batteries swapped. */
    @Test
    void wherePlansHaveBatteriesSwappedAllIsDividedAndTheOperatorIsTold() {
        RunReport report = run("explore-team", 600, 20, "100,100,100", Conditions.CALM, 1);

        assertThat(report.notes())
                .extracting(NoteResult::message)
                .anyMatch(text -> text.startsWith("Exploring ")
                        && text.endsWith("a boat more than its charge is sure to last for: batteries are to be swapped"
                                + " on the way"));
        assertThat(report.map().explorations().get(0).left().plannedM2().orElseThrow())
                .isLessThan(100);
    }

    private static void assertAllIsExplored(RunReport report, double percent) {
        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        Exploration explored = report.map().explorations().get(0);
        assertThat(explored.percent(explored.left().trueM2().orElseThrow())).isGreaterThan(percent);
        assertNoBoatStoppedDead(report);
    }

    private static void assertNoBoatStoppedDead(RunReport report) {
        assertThat(report.boats())
                .allSatisfy(
                        boat -> assertThat(boat.batteryPercent()).as(boat.id()).isPositive());
    }

    /** What is left of each charge is sure to last straight to where its boat began. */
    private static void assertAllMayComeHome(RunReport report) {
        assertThat(report.boats()).allSatisfy(boat -> {
            TrackPoint home = boat.track().get(0);
            TrackPoint end = boat.track().get(boat.track().size() - 1);
            double homeM = Math.hypot(end.eastM() - home.eastM(), end.northM() - home.northM());
            assertThat(Charge.usual(boat.batteryPercent()).sureM())
                    .as(boat.id())
                    .isGreaterThanOrEqualTo(homeM);
        });
    }

    private static RunReport run(
            String planId, double areaM, double spacingM, String charges, Conditions conditions, long seed) {
        return run(TestRuns.plan(planId), areaM, spacingM, charges, conditions, seed);
    }

    /** The plan that explores an area, which says whether charges are to last for the ways home. */
    private static RunPlan keepingHome(boolean keep) {
        Project project = TestRuns.LIBRARY.projectOf("explore-area").orElseThrow();
        String spacing = "\"spacing\": {\"variable\": \"@spacing\"}";
        String text = new ProjectWriter(TestRuns.LIBRARY.vocabulary())
                .text(project)
                .replace(spacing, spacing + ", \"keepHome\": {\"value\": " + keep + "}");
        Project changed =
                new ProjectReader(TestRuns.LIBRARY.vocabulary()).read(text).orThrow();
        return new RunPlan(
                TestRuns.LIBRARY.vocabulary(),
                changed,
                changed.plan("explore-area").orElseThrow());
    }

    private static RunReport run(
            RunPlan plan, double areaM, double spacingM, String charges, Conditions conditions, long seed) {
        return TestRuns.run(
                plan,
                RunSettings.of(
                                plan.plan().id(),
                                plan.plan().name(),
                                new FleetSettings(3, 1, areaM, seed)
                                        .on(conditions)
                                        .with(InitialCharges.parse(charges)))
                        .limitMillis(7_200_000)
                        .parameters(Map.of("@spacing", String.valueOf(spacingM)))
                        .build());
    }
}
