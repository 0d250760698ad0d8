package org.sami.crw.sim.run.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapSpot;
import org.sami.crw.report.NoGoDepth;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.run.TestRuns;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.ValueType;

/** What plans of the library leave on the map of their runs. */
class PlanMapTest {
    /** 20 m by 20 m, 30 m north-east of the centre. */
    private static final String AVOIDED = """
        "avoid": {"value": [{"outline": [
         {"lat": 45.70018, "lon": 10.72026}, {"lat": 45.70018, "lon": 10.72052},
         {"lat": 45.70036, "lon": 10.72052}, {"lat": 45.70036, "lon": 10.72026}]}]},\
        """;

    @Test
    void anAreaThatWasExploredIsCoveredByTheTracks() {
        RunPlan plan = TestRuns.plan("explore-area");

        RunReport report = TestRuns.run(plan, settings(plan, 7_200_000));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        Exploration explored = report.map().explorations().get(0);
        assertThat(report.map().explorations()).hasSize(1);
        assertThat(explored.areaM2()).isCloseTo(200 * 200, within(10.0));
        assertThat(explored.uncoveredM2() / explored.areaM2()).isLessThan(0.03);
        assertThat(report.map().areas()).singleElement().satisfies(area -> {
            assertThat(area.kind()).isEqualTo(MapArea.Kind.EXPLORED);
            assertThat(area.outline())
                    .hasSize(4)
                    .allSatisfy(p -> assertThat(Math.abs(p.eastM())).isCloseTo(100, within(0.1)));
        });
    }

    @Test
    void whatWasNotExploredWhenTheRunStoppedIsOnTheMap() {
        RunPlan plan = TestRuns.plan("explore-area");

        Exploration half =
                TestRuns.run(plan, settings(plan, 120_000)).map().explorations().get(0);

        assertThat(half.uncoveredM2()).isBetween(0.2 * half.areaM2(), 0.99 * half.areaM2());
        assertThat(half.uncovered()).isNotEmpty().allMatch(piece -> piece.kind() == MapArea.Kind.UNCOVERED);
        assertThat(half.uncovered().stream().mapToDouble(PlanMapTest::areaM2).sum())
                .isCloseTo(half.uncoveredM2(), within(20.0));
    }

    @Test
    void whatIsToBeAvoidedIsOnTheMapAndNotToBeExplored() {
        RunPlan library = TestRuns.plan("explore-area");
        String text = new ProjectWriter(library.vocabulary()).text(library.project());
        String avoiding = text.replaceFirst("(\"area\": \\{\\s*\"variable\": \"@area\"\\s*},?)", AVOIDED + "$1");
        assertThat(avoiding).isNotEqualTo(text);
        Project project = new ProjectReader(library.vocabulary()).read(avoiding).orThrow();
        RunPlan plan = new RunPlan(
                library.vocabulary(), project, project.plan("explore-area").orElseThrow());

        RunReport report = TestRuns.run(plan, settings(plan, 60_000));

        assertThat(report.map().areas())
                .extracting(MapArea::kind)
                .containsExactlyInAnyOrder(MapArea.Kind.EXPLORED, MapArea.Kind.AVOIDED);
        assertThat(report.map().explorations().get(0).areaM2()).isCloseTo(200 * 200 - 20 * 20, within(15.0));
    }

    /** In lanes of 20 m: its rock lies across two of them. */
    @Test
    void whatTheProjectAvoidsIsOnTheMapAndIsNeitherExploredNorEntered() {
        RunPlan library = TestRuns.plan("explore-area");
        Project rocks = library.project()
                .withGlobals(List.of(new VariableSpec(
                        "@noGo",
                        new ValueType.ListOf(ValueType.Simple.AREA),
                        Optional.of(new ListValue(List.of(
                                new GeoArea(List.of(at(20, 20), at(40, 20), at(40, 40), at(20, 40)), List.of())))))));
        RunPlan plan = new RunPlan(
                library.vocabulary(), rocks, rocks.plan("explore-area").orElseThrow());

        RunReport report = TestRuns.run(plan, settings(plan, 7_200_000));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.map().areas())
                .extracting(MapArea::kind)
                .containsExactlyInAnyOrder(MapArea.Kind.EXPLORED, MapArea.Kind.AVOIDED);
        assertThat(NoGoDepth.of(report)).hasValue(0);
        Exploration explored = report.map().explorations().get(0);
        assertThat(explored.areaM2()).isCloseTo(200 * 200 - 20 * 20, within(15.0));
        assertThat(explored.percent(explored.left().plannedM2().orElseThrow())).isGreaterThan(99.9);
        assertThat(explored.percent(explored.left().trueM2().orElseThrow())).isGreaterThan(99.5);
    }

    @Test
    void placesWhereBoatsGatherAreOnTheMap() {
        RunPlan plan = TestRuns.plan("station-keep");

        RunReport report = TestRuns.run(plan, TestRuns.settings(plan, 3, 1, 1));

        List<MapSpot> assembly = report.map().spots().stream()
                .filter(spot -> spot.kind() == MapSpot.Kind.ASSEMBLY)
                .toList();
        assertThat(assembly).extracting(MapSpot::boat).containsExactlyInAnyOrder("boat1", "boat2", "boat3");
        assertThat(report.map().spots())
                .filteredOn(spot -> spot.kind() == MapSpot.Kind.PLAN)
                .hasSize(1);
    }

    @Test
    void locationsAreNotDrawnTwice() {
        RunPlan plan = TestRuns.plan("clv");

        assertThat(TestRuns.run(plan, TestRuns.settings(plan, 3, 5, 1)).map().spots())
                .isEmpty();
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(GeoPoint.of(45.7, 10.72), eastM, northM);
    }

    private static double areaM2(MapArea area) {
        double holes = area.holes().stream().mapToDouble(PlanMapTest::ringM2).sum();
        return ringM2(area.outline()) - holes;
    }

    private static double ringM2(List<org.sami.crw.report.MapPoint> ring) {
        double twice = 0;
        for (int i = 0; i < ring.size(); i++) {
            var a = ring.get(i);
            var b = ring.get((i + 1) % ring.size());
            twice += a.eastM() * b.northM() - b.eastM() * a.northM();
        }
        return Math.abs(twice) / 2;
    }

    private static RunSettings settings(RunPlan plan, long stopMillis) {
        RunSettings usual = TestRuns.settings(plan, 2, 1, 1);
        return RunSettings.of(usual.plan(), usual.mission(), new FleetSettings(2, 1, 200, 1))
                .speed(usual.speed())
                .limitMillis(stopMillis)
                .parameters(usual.parameters())
                .answerAfterMillis(usual.answerAfterMillis())
                .answers(usual.answers())
                .build();
    }
}
