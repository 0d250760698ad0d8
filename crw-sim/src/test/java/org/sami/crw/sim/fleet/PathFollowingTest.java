package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
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
@Tag("long")
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

    /** Areas whose rims leave many small pieces between lanes. */
    @ParameterizedTest
    @CsvSource({
        "jagged, 1, 5",
        "jagged, 2, 10",
        "jagged, 3, 10",
        "spiral, 14, 5",
        "spiral, 14, 10",
        "spiral, 20, 10",
        "spiral, 10, 5"
    })
    void jaggedAreasAndSpiralsAreCoveredToo(String shape, int number, double spacingM) {
        SimulatedTestWorld world = world(Conditions.CALM);
        double[] corners = shape.equals("spiral") ? spiral(number) : jagged(new Random(number));
        GeoArea area = new GeoArea(world.points(corners), List.of());
        Coverage coverage = new LawnMower()
                .cover(CoverageProblem.of(
                        Map.of("boat1", Optional.of(world.boat().position())), area, spacingM));

        TrueTrack track =
                TrueTrack.of(world, coverage.shares().get("boat1").path().points(), 14_400);

        assertThat(track.isCompleted()).isTrue();
        assertThat(track.covered(area, spacingM)).isGreaterThanOrEqualTo(0.995);
    }

    /** A star of 40 corners. */
    private static double[] jagged(Random random) {
        double[] corners = new double[80];
        for (int i = 0; i < 40; i++) {
            double radiusM = 60 + 40 * random.nextDouble();
            corners[2 * i] = 120 + radiusM * Math.cos(2 * Math.PI * i / 40);
            corners[2 * i + 1] = radiusM * Math.sin(2 * Math.PI * i / 40);
        }
        return corners;
    }

    /** A channel of that width that winds a little more than twice around its beginning. */
    private static double[] spiral(double widthM) {
        int steps = 90;
        double[] corners = new double[4 * (steps + 1)];
        for (int i = 0; i <= steps; i++) {
            double angle = 4.5 * Math.PI * i / steps;
            double radiusM = 1.1 * widthM + angle / Math.PI * widthM;
            int back = corners.length - 2 - 2 * i;
            corners[2 * i] = 120 + (radiusM + widthM / 2) * Math.cos(angle);
            corners[2 * i + 1] = (radiusM + widthM / 2) * Math.sin(angle);
            corners[back] = 120 + (radiusM - widthM / 2) * Math.cos(angle);
            corners[back + 1] = (radiusM - widthM / 2) * Math.sin(angle);
        }
        return corners;
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
