package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

class FleetDrivesTest {

    @Test
    void boatVisitsItsPointsInOrderAndReportsProgressAndCompletion() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        double[] path = {60, 0, 60, 80, -20, 80, -20, 10};
        world.proxy().commands().submit(world.path(7, path));

        List<Integer> reached = new ArrayList<>();
        for (int tick = 0; tick < 4000; tick++) {
            world.run(0.1);
            for (int i = 0; i < 4; i++) {
                if (world.distanceTo(path[2 * i], path[2 * i + 1]) <= 3.0 && !reached.contains(i)) {
                    reached.add(i);
                }
            }
        }

        assertThat(reached).containsExactly(0, 1, 2, 3);
        assertThat(world.reports())
                .containsExactly(
                        "link LINKED",
                        "battery NOMINAL",
                        "visited 1 of m7-boat1",
                        "visited 2 of m7-boat1",
                        "visited 3 of m7-boat1",
                        "visited 4 of m7-boat1",
                        "completed m7-boat1");
        assertThat(world.proxy().commands().current()).isEmpty();
        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.HOLD);
        assertThat(world.hull().speedMps()).isZero();
        assertThat(world.hull().distanceM()).isBetween(270.0, 300.0);
    }

    @Test
    void cruisesAtOneAndAHalfMetresASecondUnlessThePathSaysOtherwise() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 0, 500));
        world.run(60);

        assertThat(world.hull().speedMps()).isBetween(1.45, 1.55);

        FollowPath fast =
                new FollowPath("fast", 1, 1, world.points(0, 1000), OptionalDouble.of(3.0), 0, Priority.MEDIUM, false);
        world.proxy().commands().submit(fast);
        world.run(60);

        assertThat(world.hull().speedMps()).isBetween(2.9, 3.1);
    }

    @Test
    void startsAtTheFirstUnvisitedPoint() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 200, 0, 0, 60).startingAt(1));
        world.run(90);

        assertThat(world.distanceTo(0, 60)).isLessThan(5);
        assertThat(world.hull().distanceM()).isLessThan(70);
        assertThat(world.reports()).endsWith("visited 2 of m1-boat1", "completed m1-boat1");
    }

    @Test
    void pathWithNothingLeftCompletesAtOnceWithoutTheBoat() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 50, 0).startingAt(1));
        world.proxy().commands().submit(world.path(2));

        assertThat(world.reports()).containsExactly("completed m1-boat1", "completed m2-boat1");
        world.run(10);
        assertThat(world.boat().executed()).isEmpty();
    }

    @Test
    void newPathOfTheSameMissionReplacesTheOldOneOnTheWay() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path("old", 1, Priority.MEDIUM, 0, 300));
        world.run(40);
        double northM = world.hull().northM();
        world.proxy().commands().submit(world.path("new", 1, Priority.MEDIUM, 60, northM, 60, 0));
        world.run(150);

        assertThat(world.reports())
                .contains("SUPERSEDED old", "visited 1 of new", "completed new")
                .doesNotContain("completed old");
        assertThat(world.distanceTo(60, 0)).isLessThan(5);
        assertThat(world.hull().northM()).isLessThan(northM);
    }

    @Test
    void withdrawingAtAnyMomentLeavesTheBoatStopped() {
        SplittableRandom random = new SplittableRandom(99);
        for (int trial = 0; trial < 150; trial++) {
            SimulatedTestWorld world = new SimulatedTestWorld(1, trial, FleetConfig.DEFAULT);
            long atMs = random.nextLong(
                    trial < 60 ? 600 : 120_000); // many while the link is coming up and the path goes over
            if (random.nextBoolean()) {
                world.run(1);
            }
            world.proxy().commands().submit(world.path(5, 40, 30, -30, 60, 50, 50));
            world.clock.runUntil(world.clock.nowMs() + atMs);
            world.fleet.proxies().withdraw(5);
            world.run(6);

            double northM = world.hull().northM();
            double eastM = world.hull().eastM();
            assertThat(world.hull().speedMps()).as("after %d ms", atMs).isZero();
            world.run(60);
            assertThat(world.distanceTo(eastM, northM)).as("after %d ms", atMs).isZero();
            assertThat(world.proxy().explain().text()).contains("no mission wants anything of it");
        }
    }

    @Test
    void everyBoatOfAFleetIsStoppedWhenItsMissionIsWithdrawn() {
        SimulatedTestWorld world = new SimulatedTestWorld(5);
        for (SimulatedBoat boat : world.fleet.boats()) {
            String id = "m1-" + boat.id();
            boat.proxy().commands().submit(FollowPath.of(id, 1, 1, world.points(0, 400), Priority.MEDIUM));
        }
        world.run(30);

        assertThat(world.fleet.proxies().withdraw(1)).hasSize(5);
        world.run(5);

        assertThat(world.fleet.boats()).allSatisfy(boat -> {
            assertThat(boat.hull().speedMps()).isZero();
            assertThat(boat.server().mode()).isEqualTo(BoatMode.STOPPED);
        });
    }

    @Test
    void equalSeedsGiveEqualTracksAndOtherSeedsOtherBatteries() {
        SimulatedTestWorld first = driveAround(17);
        SimulatedTestWorld second = driveAround(17);
        SimulatedTestWorld other = driveAround(18);

        for (int i = 0; i < 3; i++) {
            SimulatedBoat boat = first.fleet.boats().get(i);
            SimulatedBoat twin = second.fleet.boats().get(i);
            assertThat(boat.track()).isEqualTo(twin.track()).hasSize(301);
            assertThat(boat.executed()).extracting(ExecutedCommand::commandId).isNotEmpty();
            assertThat(boat.batteryPercent()).isEqualTo(twin.batteryPercent());
            assertThat(boat.batteryPercent())
                    .isNotEqualTo(other.fleet.boats().get(i).batteryPercent());
        }
        assertThat(first.recorders.get("boat2").lines).isEqualTo(second.recorders.get("boat2").lines);
    }

    /** So that it cannot matter which thread ticks which boat, and when. */
    @Test
    void ordersInWhichBoatsAreTickedGiveTheSameTracksAndNewsInTheSameOrder() {
        TickHelpers backwards = new TickHelpers(0) {
            @Override
            void begin(int size, IntConsumer action) {
                IntStream.rangeClosed(1, size).forEach(i -> action.accept(size - i));
            }
        };
        List<String> news = new ArrayList<>();
        List<String> newsBackwards = new ArrayList<>();
        List<String> newsHelped = new ArrayList<>();

        List<List<TruePosition>> tracks = tracksInFieldWater(new TickHelpers(0), news);

        assertThat(tracksInFieldWater(backwards, newsBackwards)).isEqualTo(tracks);
        assertThat(tracksInFieldWater(new TickHelpers(3), newsHelped)).isEqualTo(tracks);
        assertThat(newsBackwards).isEqualTo(news).hasSizeGreaterThan(1000);
        assertThat(newsHelped).isEqualTo(news);
    }

    /** Of boats that cross each other's ways. */
    private static List<List<TruePosition>> tracksInFieldWater(TickHelpers helpers, List<String> news) {
        VirtualClock clock = new VirtualClock();
        Consumer<FleetEvent> listener = event -> {
            if (event instanceof FleetEvent.StatusReported reported) {
                news.add(clock.nowMs() + " " + reported.status());
            }
        };
        FleetConfig config = FleetConfig.DEFAULT.withConditions(NamedConditions.FIELD.conditions());
        SimulatedFleet fleet = new SimulatedFleet(clock, 5, 20, 45.4, 10.9, id -> listener, config);
        fleet.use(helpers);
        fleet.start();
        for (SimulatedBoat boat : fleet.boats()) {
            int i = fleet.boats().indexOf(boat);
            GeoPoint there = GeoPoint.of(
                    fleet.frame().latDeg(95 - 5 * i, 60), fleet.frame().lonDeg(95 - 5 * i, 60));
            boat.proxy().commands().submit(FollowPath.of("m1-" + boat.id(), 1, 1, List.of(there), Priority.MEDIUM));
        }
        clock.runUntil(90_000);
        fleet.endHelpers();
        return fleet.boats().stream().map(SimulatedBoat::track).toList();
    }

    private static SimulatedTestWorld driveAround(long seed) {
        SimulatedTestWorld world = new SimulatedTestWorld(3, seed, FleetConfig.DEFAULT);
        SplittableRandom random = new SplittableRandom(4);
        for (SimulatedBoat boat : world.fleet.boats()) {
            double[] path = random.doubles(10, -100, 100).toArray();
            boat.proxy().commands().submit(FollowPath.of("m1-" + boat.id(), 1, 1, world.points(path), Priority.MEDIUM));
        }
        world.run(300);
        return world;
    }

    @Test
    void boatsStartOnALineFiveMetresApart() {
        SimulatedTestWorld world = new SimulatedTestWorld(3);

        assertThat(world.fleet.boats()).extracting(SimulatedBoat::id).containsExactly("boat1", "boat2", "boat3");
        assertThat(world.fleet.boats()).extracting(boat -> boat.hull().eastM()).containsExactly(0.0, 5.0, 10.0);
        assertThat(world.fleet.boat("boat4")).isEmpty();
    }

    @Test
    void proxyKnowsWhatTelemetryTells() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 0, 100));
        world.run(30.05);

        var status = world.proxy().status();
        var pose = status.pose().orElseThrow();
        GeoPoint known = pose.position();
        assertThat(status.link()).isEqualTo(LinkState.LINKED);
        assertThat(status.mode()).contains(BoatMode.PATH);
        assertThat(pose.boatTimeMs()).isEqualTo(29_100);
        assertThat(world.fleet.frame().northM(known.latDeg(), known.lonDeg()))
                .isBetween(world.hull().northM() - 1.6, world.hull().northM());
        assertThat(status.battery().orElseThrow().percent())
                .isBetween(world.hull().batteryPercent(), 100.0);
        assertThat(world.recorders.get("boat1").statuses).isEqualTo(30);
    }

    @Test
    void startingTwiceTicksOnce() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.fleet.start();
        world.run(0.05);
        world.fleet.stop();
        world.fleet.start();
        world.proxy().commands().submit(world.path(1, 0, 500));
        world.run(20);
        double northM = world.hull().northM();
        world.run(10);

        assertThat(world.hull().northM() - northM).isBetween(14.5, 15.5);
    }
}
