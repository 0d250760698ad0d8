package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.DepthsPart;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.crw.sim.layer.CurrentField;
import org.sami.crw.sim.layer.DepthGrid;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.SettingsMap;

/** Runs on water that differs by place: boats measure its depth and drift with its current. */
class LayersRunTest {
    /** From 2 m in the west to 10 m in the east of the area. */
    private static final DepthGrid SLOPE = DepthGrid.parse("""
        ncols 2
        nrows 2
        xllcenter 10.718
        yllcenter 45.698
        cellsize 0.004
        2 10
        2 10
        """);

    private static final CurrentField CURRENTS =
            CurrentField.parse("lat,lon,speed,direction\n45.7,10.7190,0.3,90\n45.7,10.7210,0.1,180\n");

    private static final WaterLayers BOTH = new WaterLayers(Optional.of(SLOPE), Optional.of(CURRENTS));

    private static RunSettings settings(WaterLayers layers) {
        return RunSettings.of("clv", "Visit", new FleetSettings(2, 6, 120, 1).on(layers))
                .limitMillis(3_600_000)
                .build();
    }

    private static RunReport run(WaterLayers layers) {
        return TestRuns.run(TestRuns.plan("clv"), settings(layers));
    }

    @Test
    void boatsMeasureTheDepthAtTheirPlaceAndReachAllLocationsInTheCurrent() {
        RunReport report = run(BOTH);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locationsVisited()).isEqualTo(6);
        assertThat(report.readings()).hasSizeGreaterThan(100).allSatisfy(reading -> {
            assertThat(reading.sensor()).isEqualTo("hds");
            assertThat(reading.channel()).isEqualTo("depth");
            double trueM = SLOPE.depthM(reading.latDeg(), reading.lonDeg()).orElseThrow();
            assertThat(reading.values().get(0)).isCloseTo(trueM, within(0.3));
        });
    }

    @Test
    void equalLayersGiveEqualRunsAndNoneGiveTheRunThatThereWas() {
        String hash = run(BOTH).result().runHash();
        String without = TestRuns.run(
                        TestRuns.plan("clv"),
                        RunSettings.of("clv", "Visit", new FleetSettings(2, 6, 120, 1))
                                .limitMillis(3_600_000)
                                .build())
                .result()
                .runHash();

        assertThat(run(BOTH).result().runHash()).isEqualTo(hash);
        assertThat(run(WaterLayers.NONE).result().runHash()).isEqualTo(without).isNotEqualTo(hash);
    }

    @Test
    void aBoatWithoutMotorsDriftsWithTheCurrentAtItsPlace() {
        LocalFrame frame = new LocalFrame(45.7, 10.7190);
        SimulatedHull hull = new SimulatedHull(HullConfig.DEFAULT, frame, 0, 0, 1);
        hull.setCurrents(CURRENTS);

        for (int i = 0; i < 100; i++) {
            hull.step(0.1);
        }

        assertThat(hull.eastM()).isCloseTo(3, within(0.02));
        assertThat(hull.northM()).isCloseTo(0, within(0.02));
    }

    @Test
    void anAreaThatIsExploredIsMappedAndComparedWithTheTruth() {
        RunReport report = TestRuns.run(
                TestRuns.plan("explore-area"),
                RunSettings.of(
                                "explore-area",
                                "Map",
                                new FleetSettings(2, 6, 100, 1)
                                        .on(new WaterLayers(Optional.of(SLOPE), Optional.empty())))
                        .parameters(Map.of("@spacing", "10"))
                        .limitMillis(3_600_000)
                        .build());

        DepthsPart map = report.part(DepthsPart.class).orElseThrow();
        assertThat(map.cells()).hasSizeGreaterThan(400); // 100 m by 100 m, in squares of 5 m
        assertThat(map.leastM()).isGreaterThan(2);
        assertThat(map.mostM()).isLessThan(10);
        assertThat(map.error().orElseThrow().meanM()).isBetween(0.001, 0.1);
        assertThat(map.error().orElseThrow().p95M()).isBetween(0.01, 0.2);
    }

    @Test
    void withoutDepthsThereIsNoMap() {
        assertThat(run(WaterLayers.NONE).part(DepthsPart.class)).isEmpty();
    }

    @Test
    void layersAreKeptWithTheSettings() {
        assertThat(SettingsMap.read(SettingsMap.write(settings(BOTH)))).isEqualTo(settings(BOTH));
        assertThat(SettingsMap.write(settings(WaterLayers.NONE))).doesNotContainKeys("depths", "currents");
    }
}
