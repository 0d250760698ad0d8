package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.SensorSetting;

/** Boats in current, wind and with instruments that err: the controller still brings them where they are sent. */
class RoughWaterTest {

    private static FleetConfig on(double gpsM, double compassDeg, String current, String wind, String... sensors) {
        List<SensorSetting> settings =
                List.of(sensors).stream().map(SensorSetting::parse).toList();
        return FleetConfig.DEFAULT.withConditions(
                new Conditions(gpsM, compassDeg, Flow.parse(current), Flow.parse(wind), settings));
    }

    @ParameterizedTest
    @CsvSource({
        "0,   0, 0@0,    0@0",
        "1.5, 5, 0@0,    0@0",
        "0,   0, 0.5@90, 0@0",
        "0,   0, 0.5@0,  0@0",
        "0,   0, 0@0,    8@315",
        "1.5, 5, 0.4@45, 6@200",
        "3,  10, 0.6@270, 0@0",
    })
    void boatReachesAllItsWaypointsAndKeepsItsStation(double gpsM, double compassDeg, String current, String wind) {
        for (long seed = 1; seed <= 5; seed++) {
            SimulatedTestWorld world = new SimulatedTestWorld(1, seed, on(gpsM, compassDeg, current, wind));
            world.run(1);
            world.proxy().commands().submit(world.path(1, 60, 40, -50, 80, -50, -60, 30, 0));
            List<Double> nearestM = new ArrayList<>(List.of(1e9, 1e9, 1e9, 1e9));
            double[][] points = {{60, 40}, {-50, 80}, {-50, -60}, {30, 0}};
            for (int i = 0; i < 6000 && !world.reports().contains("completed m1-boat1"); i++) {
                world.run(0.1);
                for (int p = 0; p < points.length; p++) {
                    nearestM.set(p, Math.min(nearestM.get(p), world.distanceTo(points[p][0], points[p][1])));
                }
            }
            double arrivedM = 3 + 3.5 * gpsM; // where the boat takes itself to be within 3 m

            assertThat(world.reports()).as("seed %d", seed).anyMatch(line -> line.startsWith("completed"));
            assertThat(nearestM).as("seed %d", seed).allMatch(metres -> metres <= arrivedM);
            double farthestM = 0;
            for (int i = 0; i < 600; i++) {
                world.run(1);
                farthestM = Math.max(farthestM, world.distanceTo(30, 0));
            }
            assertThat(farthestM).as("on its station, seed %d", seed).isLessThan(9 + 4 * gpsM);
        }
    }

    @Test
    void velocityMultiplierAndGainsSetByTheBaseChangeHowTheBoatDrives() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.run(1);
        world.proxy().commands().submit(world.path(1, 0, 400));
        world.run(30);
        double before = world.hull().speedMps();
        world.proxy().settings().setVelocityMultiplier(0.5);
        world.run(30);
        assertThat(world.hull().speedMps()).isBetween(0.45 * before, 0.55 * before);

        world.proxy().settings().setGains(GainAxis.SPEED, new Gains(0, 0, 0));
        world.proxy().settings().setLostLinkAction(LostLinkAction.DRIFT);
        world.run(1);
        BoatTuning told = world.proxy().settings().inForce().orElseThrow();
        assertThat(told.heading()).isEqualTo(new Gains(1.2, 0, 0));
        assertThat(told.speed()).isEqualTo(new Gains(0, 0, 0));
        assertThat(told.velocityMultiplier()).isEqualTo(0.5);
        assertThat(told.lostLinkAction()).isEqualTo(LostLinkAction.DRIFT);
    }

    @Test
    void readingsReachTheBaseAtTheirRatesFromEveryBoatAndDifferOverTheWater() {
        List<String> boats = new ArrayList<>();
        List<BoatReading> readings = new ArrayList<>();
        Consumer<FleetEvent> listener = event -> {
            if (event instanceof FleetEvent.Measured measured) {
                boats.add(measured.boat());
                readings.add(measured.reading());
            }
        };
        var clock = new org.sami.crw.sim.clock.VirtualClock();
        SimulatedFleet fleet = new SimulatedFleet(
                clock, 3, 2, 45.4, 10.9, id -> listener, on(1, 0, "0@0", "0@0", "temperature@1", "oxygen@0.2"));
        fleet.start();
        clock.runUntil(100_500);

        assertThat(boats).contains("boat1", "boat2");
        assertThat(readings.stream().filter(r -> r.channel().equals("temperature")))
                .hasSizeBetween(198, 202);
        assertThat(readings.stream().filter(r -> r.channel().equals("oxygen"))).hasSizeBetween(38, 42);
        assertThat(readings)
                .allMatch(r -> r.sensor().equals("water") && r.values().size() == 1);
    }

    @Test
    void equalSeedsGiveEqualTracksInRoughWaterToo() {
        List<List<TruePosition>> tracks = new ArrayList<>();
        for (long seed : new long[] {4, 4, 5}) {
            SimulatedTestWorld world = new SimulatedTestWorld(1, seed, on(1.5, 5, "0.4@45", "6@200", "temperature"));
            world.run(1);
            world.proxy().commands().submit(world.path(1, 60, 40, -50, 80));
            world.run(200);
            tracks.add(world.boat().track());
        }

        assertThat(tracks.get(1)).isEqualTo(tracks.get(0));
        assertThat(tracks.get(2)).isNotEqualTo(tracks.get(0));
    }
}
