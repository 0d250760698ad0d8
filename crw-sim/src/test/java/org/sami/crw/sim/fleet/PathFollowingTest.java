package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageProblem;
import org.sami.crw.service.coverage.LawnMower;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** How near boats keep to the path that they were given: measured on where the hulls truly are. */
class PathFollowingTest {
    private static final FleetConfig ENDURING =
            FleetConfig.DEFAULT.withHull(HullConfig.DEFAULT.withBatteryPercentPerM(0));

    private static SimulatedTestWorld world(Conditions conditions) {
        SimulatedTestWorld world = new SimulatedTestWorld(1, 1, ENDURING.withConditions(conditions));
        world.run(1);
        return world;
    }

    private static Conditions flowing(String current, String wind) {
        return new Conditions(0, 0, Flow.parse(current), Flow.parse(wind), List.of());
    }

    @ParameterizedTest
    @ValueSource(doubles = {5, 10})
    void lanesInCalmWaterCoverTheWholeArea(double spacingM) {
        SimulatedTestWorld world = world(Conditions.CALM);
        GeoArea area = new GeoArea(world.points(20, 20, 140, 20, 140, 110, 20, 110), List.of());
        Coverage coverage = new LawnMower()
                .cover(CoverageProblem.of(
                        Map.of("boat1", Optional.of(world.boat().position())), area, spacingM));

        TrueTrack track =
                TrueTrack.of(world, coverage.shares().get("boat1").path().points(), 7200);

        assertThat(track.isCompleted()).isTrue();
        assertThat(track.covered(area, spacingM)).isGreaterThanOrEqualTo(0.995);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void boatKeepsToAnyPathInCalmWater(long seed) {
        SimulatedTestWorld world = world(Conditions.CALM);
        List<GeoPoint> path = anyPath(world, new Random(seed));
        List<GeoPoint> driven = new ArrayList<>(List.of(world.boat().position()));
        driven.addAll(path);

        TrueTrack track = TrueTrack.of(world, path, 7200);

        assertThat(track.isCompleted()).isTrue();
        assertThat(track.farthestFromM(driven)).isLessThan(0.4);
    }

    @ParameterizedTest
    @CsvSource({"0.5@90, 0@0", "0.3@200, 5@270", "0@0, 8@45"})
    void boatKeepsToItsPathInCurrentAndWind(String current, String wind) {
        SimulatedTestWorld world = world(flowing(current, wind));
        List<GeoPoint> path = anyPath(world, new Random(7));
        List<GeoPoint> driven = new ArrayList<>(List.of(world.boat().position()));
        driven.addAll(path);

        TrueTrack track = TrueTrack.of(world, path, 7200);

        assertThat(track.isCompleted()).isTrue();
        assertThat(track.farthestFromM(driven)).isLessThan(3);
    }

    /** Twenty legs of 1 to 100 m, with turns of any angle. */
    private static List<GeoPoint> anyPath(SimulatedTestWorld world, Random random) {
        double eastM = 0;
        double northM = 0;
        double course = 0;
        double[] places = new double[40];
        for (int i = 0; i < 20; i++) {
            course += (random.nextDouble() - 0.5) * 2 * Math.PI;
            double legM = Math.exp(random.nextDouble() * Math.log(100));
            eastM += legM * Math.sin(course);
            northM += legM * Math.cos(course);
            places[2 * i] = eastM;
            places[2 * i + 1] = northM;
        }
        return world.points(places);
    }
}
