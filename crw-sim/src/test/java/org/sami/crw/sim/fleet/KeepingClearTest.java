package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.coverage.Coverage;
import org.sami.crw.service.coverage.CoverageProblem;
import org.sami.crw.service.coverage.LawnMower;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.SafestPath;
import org.sami.crw.service.path.ShortestPath;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.SafetyMargin;
import org.sami.crw.service.water.Water;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Whether boats stay out of what they are to avoid: measured on where the hulls truly are. */
@Tag("long")
class KeepingClearTest {
    /** A boat goes on for some seconds before it knows that its link is lost. */
    private static final double BEFORE_IT_RETURNS_M = 12;

    private static SimulatedTestWorld world(Conditions conditions, long seed) {
        FleetConfig enduring = FleetConfig.DEFAULT
                .withHull(HullConfig.DEFAULT.withBatteryPercentPerM(0))
                .withConditions(conditions);
        SimulatedTestWorld world = new SimulatedTestWorld(1, seed, enduring);
        world.run(1);
        return world;
    }

    @ParameterizedTest
    @CsvSource({"CALM, 1", "CALM, 2", "CALM, 3", "FIELD, 1", "FIELD, 2", "ROUGH, 3"})
    void theShortestWayIsDrivenAroundWhatIsToBeAvoided(NamedConditions name, long seed) {
        Conditions conditions = name.conditions();
        SimulatedTestWorld world = world(conditions, seed);
        List<GeoArea> rocks = rocks(world, new Random(seed), 12);
        Water water =
                Water.of(world.boat().position(), rocks, Optional.empty()).drivenWith(conditions.crossTrackError());
        GeoPoint goal = world.points(400, 0).get(0);
        PathAnswer.Way way = (PathAnswer.Way)
                new ShortestPath().find(new PathProblem(world.boat().position(), goal, water, 5));

        TrueTrack track = TrueTrack.of(world, way.points(), 7200);

        assertThat(track.isCompleted()).isTrue();
        double announcedM = new SafetyMargin(conditions.crossTrackError()).insideM(way.clearanceM());
        assertThat(track.deepestInM(rocks)).isLessThanOrEqualTo(announcedM);
        if (name == NamedConditions.CALM) {
            assertThat(announcedM).isZero();
        }
    }

    /** The plan knows nothing of the rocks between its points; neither did the boat when another command took it away. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void anyPathIsDrivenAroundWhatIsToBeAvoidedAlsoWhenTheBoatComesBackFromElsewhere(long seed) {
        SimulatedTestWorld world = world(Conditions.CALM, seed);
        List<GeoArea> rocks = rocks(world, new Random(seed), 12);
        Water water = Water.of(world.boat().position(), rocks, Optional.empty()).drivenWith(CrossTrackError.CALM);
        List<GeoPoint> points = world.points(400, 0, 30, 90, 30, -90, 400, 10);
        FollowPath path = FollowPath.of("way", 1, 1, points, Priority.MEDIUM).in(water);
        FollowPath elsewhere = FollowPath.goTo(
                        "aside", 2, 2, world.points(200, 130).get(0), Priority.CRITICAL)
                .in(water);

        TrueTrack track = TrueTrack.of(world, path, 7200, 120, elsewhere);

        assertThat(track.isCompleted()).isTrue();
        assertThat(track.deepestInM(rocks)).isZero();
        assertThat(points)
                .allSatisfy(point -> assertThat(track.distanceM(point)).isLessThan(0.6));
        assertThat(world.reports()).contains("completed aside", "visited 4 of way");
    }

    /** Another command comes while the boat passes a corner, as an alarm does: it slows down on its line before it turns off. */
    @ParameterizedTest
    @CsvSource({"1.5, 6", "1.5, 10", "3, 3", "3, 6"})
    void boatThatIsSentElsewhereCutsNoCorner(double speedMps, long seed) {
        SimulatedTestWorld first = world(Conditions.CALM, seed);
        List<GeoArea> rocks = rocks(first, new Random(seed), 12);
        Water water = Water.of(first.boat().position(), rocks, Optional.empty()).drivenWith(CrossTrackError.CALM);
        FollowPath path = FollowPath.of("way", 1, 1, first.points(400, 0, 30, 90, 30, -90, 400, 10), Priority.MEDIUM)
                .in(water)
                .atSpeed(speedMps);
        List<Double> nearRocks = momentsNear(first, path, water, 10);
        List<GeoPoint> goals = first.points(200, 90, 200, -90, 0, 0, 400, 60);

        for (int i = 0; i < nearRocks.size(); i++) {
            SimulatedTestWorld world = world(Conditions.CALM, seed);
            FollowPath elsewhere = FollowPath.goTo("aside", 2, 2, goals.get(i % goals.size()), Priority.CRITICAL)
                    .in(water)
                    .atSpeed(speedMps);

            TrueTrack track = TrueTrack.of(world, path, nearRocks.get(i) + 60, nearRocks.get(i), elsewhere);

            assertThat(track.deepestInM(rocks))
                    .as("after %s s", nearRocks.get(i))
                    .isZero();
        }
        assertThat(nearRocks).hasSizeGreaterThan(3);
    }

    /** When a boat that drives a path is within 1.2 m of rocks, in seconds, at most so often, at least 3 s apart. */
    private static List<Double> momentsNear(SimulatedTestWorld world, FollowPath path, Water water, int most) {
        world.proxy().commands().submit(path);
        List<Double> moments = new ArrayList<>();
        double last = Double.NEGATIVE_INFINITY;
        for (double t = 0; t < 1500 && moments.size() < most; t += 0.2) {
            if (water.clearanceM(world.boat().position()) < 1.2 && t > last + 3) {
                moments.add(t);
                last = t;
            }
            world.run(0.2);
        }
        return moments;
    }

    @ParameterizedTest
    @CsvSource({
        "CALM, 1, 60",
        "CALM, 1, 300",
        "CALM, 2, 150",
        "CALM, 3, 220",
        "CALM, 4, 400",
        "FIELD, 5, 250",
        "ROUGH, 6, 250"
    })
    void lostLinkBringsTheBoatHomeAroundWhatIsToBeAvoided(NamedConditions name, long seed, double lostAfterS) {
        Conditions conditions = name.conditions();
        SimulatedTestWorld world = world(conditions, seed);
        List<GeoArea> rocks = rocks(world, new Random(seed), 12);
        Water water =
                Water.of(world.boat().position(), rocks, Optional.empty()).drivenWith(conditions.crossTrackError());
        List<GeoPoint> points = world.points(400, 0, 30, 90, 30, -90, 400, 10);
        world.proxy().settings().setLostLinkAction(LostLinkAction.RETURN);
        world.proxy()
                .commands()
                .submit(FollowPath.of("way", 1, 1, points, Priority.MEDIUM).in(water));

        TrueTrack out = TrueTrack.until(world, lostAfterS, () -> false);
        world.proxy().disconnect();
        List<GeoPoint> expected = world.proxy().wayHome();
        TrueTrack home = TrueTrack.until(
                world,
                1500,
                () -> world.distanceTo(0, 0) < 8 && world.boat().server().mode() == BoatMode.HOLD);

        assertThat(home.isCompleted()).isTrue();
        double announcedM = new SafetyMargin(conditions.crossTrackError())
                .insideM(conditions.crossTrackError().steeringM());
        assertThat(out.deepestInM(rocks)).isLessThanOrEqualTo(announcedM);
        assertThat(home.deepestInM(rocks)).isLessThanOrEqualTo(announcedM);
        assertThat(home.farthestFromM(expected)).isLessThan(BEFORE_IT_RETURNS_M + announcedM);
    }

    /** A gap of 6 m, in which a clearance of 3.5 m cannot be kept, with a rock before and a rock behind it; the ways around are twice as long. */
    @Test
    void theSafestWayIsDrivenWithItsClearanceButForTheGapThatIsTooNarrow() {
        SimulatedTestWorld world = world(Conditions.CALM, 1);
        List<GeoArea> walls = List.of(
                new GeoArea(world.points(50, 3, 350, 3, 350, 400, 50, 400), List.of()),
                new GeoArea(world.points(50, -400, 350, -400, 350, -3, 50, -3), List.of()));
        List<GeoArea> rocks = List.of(
                new GeoArea(world.points(17, -1, 33, -1, 33, 18, 17, 18), List.of()),
                new GeoArea(world.points(367, -18, 383, -18, 383, 1, 367, 1), List.of()));
        List<GeoArea> all = Stream.concat(walls.stream(), rocks.stream()).toList();
        double clearanceM = 3.5;
        Water water = Water.of(world.boat().position(), all, Optional.empty()).drivenWith(CrossTrackError.CALM);
        PathAnswer.Way way = (PathAnswer.Way) new SafestPath()
                .find(new PathProblem(
                        world.boat().position(), world.points(400, 0).get(0), water, clearanceM));

        TrueTrack track = TrueTrack.of(world, way.points(), 7200);

        assertThat(track.isCompleted()).isTrue();
        double besideM = CrossTrackError.CALM.steeringM();
        assertThat(track.nearestM(rocks)).isGreaterThan(clearanceM - besideM);
        assertThat(track.nearestM(walls)).isBetween(0.9 * 3 - besideM, 3.0);
    }

    /** Gaps in which a clearance of 8 m cannot be kept, and the shortest way through them. */
    @ParameterizedTest
    @CsvSource({"1.4, true", "1.5, true", "4, true", "1.5, false"})
    void boatsPassNarrowGapsInTheirMiddle(double widthM, boolean safest) {
        SimulatedTestWorld world = world(Conditions.CALM, 1);
        List<GeoArea> north = List.of(new GeoArea(world.points(150, -20, 250, -20, 250, 700, 150, 700), List.of()));
        double southM = -20 - widthM;
        List<GeoArea> south =
                List.of(new GeoArea(world.points(150, -700, 250, -700, 250, southM, 150, southM), List.of()));
        Water water = Water.of(
                        world.boat().position(),
                        Stream.concat(north.stream(), south.stream()).toList(),
                        Optional.empty())
                .drivenWith(CrossTrackError.CALM);
        PathProblem problem =
                new PathProblem(world.boat().position(), world.points(400, 30).get(0), water, 8);
        PathAnswer.Way way = (PathAnswer.Way) (safest ? new SafestPath() : new ShortestPath()).find(problem);

        TrueTrack track = TrueTrack.of(world, way.points(), 7200);

        assertThat(track.isCompleted()).isTrue();
        assertThat(track.nearestM(north)).isCloseTo(widthM / 2, within(0.12));
        assertThat(track.nearestM(south)).isCloseTo(widthM / 2, within(0.12));
    }

    @ParameterizedTest
    @CsvSource({"CALM, 5", "CALM, 10", "FIELD, 10", "ROUGH, 20"})
    void lanesKeepOutOfHolesAndWhatIsToBeAvoided(NamedConditions name, double spacingM) {
        Conditions conditions = name.conditions();
        SimulatedTestWorld world = world(conditions, 5);
        List<GeoPoint> hole = world.points(60, 60, 95, 70, 80, 100);
        GeoArea rock = new GeoArea(world.points(120, 30, 150, 45, 135, 60), List.of());
        GeoArea area = new GeoArea(world.points(20, 20, 180, 20, 180, 130, 20, 130), List.of(hole));
        Coverage coverage = new LawnMower()
                .cover(new CoverageProblem(
                        Map.of("boat1", Optional.of(world.boat().position())),
                        area,
                        spacingM,
                        List.of(rock),
                        Optional.empty(),
                        conditions.crossTrackError()));
        List<GeoPoint> path = coverage.shares().get("boat1").path().points();
        Water water = Water.of(world.boat().position(), List.of(rock, new GeoArea(hole, List.of())), Optional.empty());

        TrueTrack track = TrueTrack.of(world, path, 9000);

        assertThat(track.isCompleted()).isTrue();
        double announcedM = new SafetyMargin(conditions.crossTrackError()).insideM(water.clearanceM(path));
        assertThat(track.deepestInM(List.of(rock, new GeoArea(hole, List.of()))))
                .isLessThanOrEqualTo(announcedM);
        if (name == NamedConditions.CALM) {
            assertThat(announcedM).isZero();
        }
    }

    /** Rocks with five corners between the boat and its goal, 400 m to the east. */
    private static List<GeoArea> rocks(SimulatedTestWorld world, Random random, int count) {
        List<GeoArea> rocks = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double eastM = 50 + 300 * random.nextDouble();
            double northM = 120 * (random.nextDouble() - 0.5);
            double[] corners = new double[10];
            for (int corner = 0; corner < 5; corner++) {
                double radiusM = 8 + 17 * random.nextDouble();
                double angle = 2 * Math.PI * corner / 5;
                corners[2 * corner] = eastM + radiusM * Math.cos(angle);
                corners[2 * corner + 1] = northM + radiusM * Math.sin(angle);
            }
            rocks.add(new GeoArea(world.points(corners), List.of()));
        }
        return rocks;
    }
}
