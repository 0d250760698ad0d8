package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** The real firmware of a boat under a base's commands; where it truly was, its simulator says. */
@Tag("long")
@Timeout(900)
class ArduPilotBoatTest {
    private static final int NUMBER = 90; // far from where somebody tries one by hand
    private static final int SPEED = 5;
    private static final double BOOT_S = 300;
    private static final double MISSION_S = 500;
    private static final double RADIUS_M = 3;
    private static final VehicleId ID = new VehicleId(NUMBER + 1, 1);
    private static final String BOAT = "mav" + (NUMBER + 1);

    @TempDir
    private Path work;

    @Test
    void followsAPathAndGoesToAPlaceTrulyWithinTheRadius() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            connect(world);
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                GeoPoint start = start(world);
                List<GeoPoint> path = List.of(off(start, 15, 0), off(start, 15, 15), off(start, 0, 15));
                submit(world, FollowPath.of("path", 1, 1, path, Priority.MEDIUM));
                completes(world, "path");
                GeoPoint back = off(start, 0, 3);
                submit(world, FollowPath.of("back", 1, 2, List.of(back), Priority.MEDIUM));
                completes(world, "back");
                world.tell(BOAT, BoatProxy::fleetStop);
                world.until(
                        "it is stopped", BOAT, boat -> boat.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));

                assertThat(List.of(path.get(0), path.get(1), path.get(2), back))
                        .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                                .isLessThan(RADIUS_M));
                assertThat(world.faults).isEmpty();
            }
        }
    }

    @Test
    void comesHomeTheWayItWentWhenTheBaseHasDied() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work)) {
            LinkClient client =
                    new LinkClient(work.resolve("vehicles"), ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                Telemetry at = client.last(Telemetry.class).orElseThrow();
                GeoPoint start = GeoPoint.of(at.latDeg(), at.lonDeg());
                GeoPoint corner = off(start, 40, 0);
                assertThat(client.ask(new SetLostLinkAction("lost", LostLinkAction.RETURN)))
                        .isInstanceOf(Ack.class);
                List<Waypoint> path = Stream.of(corner, off(start, 40, 40), off(start, 40, 400))
                        .map(place -> new Waypoint(place.latDeg(), place.lonDeg(), 1.5))
                        .toList();
                assertThat(client.ask(new UploadWaypoints("upload", "list", path)))
                        .isInstanceOf(Ack.class);
                assertThat(client.ask(new StartWaypoints("start", "list", 0))).isInstanceOf(Ack.class);
                Await.until(
                        "it has passed the corner",
                        MISSION_S,
                        () -> client.last(Progress.class).orElseThrow().nextIndex() == 2);

                client.close();
                int died = truth.samples();

                Await.until(
                        "it is home",
                        MISSION_S,
                        () -> truth.nearestM(died, start.latDeg(), start.lonDeg()) < 2 * RADIUS_M);
                assertThat(truth.nearestM(died, corner.latDeg(), corner.lonDeg()))
                        .isLessThan(2 * RADIUS_M);
            } finally {
                client.close();
            }
        }
    }

    @Test
    void whoReplacesTheMissionUnderWayIsNoticed() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            connect(world);
            GeoPoint start = start(world);
            List<GeoPoint> path = List.of(off(start, 15, 0), off(start, 500, 0), off(start, 500, 500));
            submit(world, FollowPath.of("path", 1, 1, path, Priority.MEDIUM));
            Await.until(
                    "it is under way",
                    MISSION_S,
                    () -> world.has(FleetEvent.Progressed.class, news -> news.visited() == 1));
            try (MavlinkBase other = otherStation()) {
                MissionItem home = MissionItem.waypoint(0, start.latDeg(), start.lonDeg(), 0, 0);
                MissionItem there = MissionItem.waypoint(1, start.latDeg(), start.lonDeg() + 0.001, 0, 0);
                other.replace(ID, HeldKind.MISSION, List.of(home, there)).join();

                Await.until("it is taken", MISSION_S, () -> world.is(BOAT, boat -> !boat.isCommanding()));
                assertThat(world.alarms)
                        .anyMatch(alarm ->
                                alarm.startsWith(BOAT + " is taken by a ground station that is not heard here"));
                world.tell(BOAT, boat -> boat.handOver().takeCommand());
                Await.until(
                        "it has its own path again",
                        MISSION_S,
                        () -> other.vehicles().join().stream()
                                .anyMatch(boat -> boat.itemsHeld().orElse(0) > 2));
            }
            assertThat(world.faults).isEmpty();
        }
    }

    @Test
    void whoReplacesTheMissionUnderWayByOneOfAsManyItemsIsNoticedBeforeAnyProgress() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            connect(world);
            GeoPoint start = start(world);
            List<GeoPoint> path = List.of(off(start, 15, 0), off(start, 500, 0), off(start, 500, 500));
            submit(world, FollowPath.of("path", 1, 1, path, Priority.MEDIUM));
            Await.until(
                    "it is under way",
                    MISSION_S,
                    () -> world.has(FleetEvent.Progressed.class, news -> news.visited() == 1));
            try (MavlinkBase other = otherStation()) {
                List<MissionItem> ours = other.held(ID, HeldKind.MISSION).join();
                double eastDeg = off(start, 0, 93).lonDeg() - start.lonDeg();
                List<MissionItem> theirs = ours.stream()
                        .map(item -> item.command() == 16 && item.number() > 0
                                ? MissionItem.waypoint(item.number(), start.latDeg(), item.lonDeg() + eastDeg, 0, 0)
                                : item)
                        .toList();

                assertThat(theirs).hasSameSizeAs(ours);
                other.replace(ID, HeldKind.MISSION, theirs).join();

                Await.until("it is taken", MISSION_S, () -> world.is(BOAT, boat -> !boat.isCommanding()));
                assertThat(world.alarms)
                        .anyMatch(alarm ->
                                alarm.startsWith(BOAT + " is taken by a ground station that is not heard here"))
                        .anyMatch(alarm -> alarm.endsWith("it holds another mission than it was given"));
                assertThat(world.has(FleetEvent.Progressed.class, news -> news.visited() > 1))
                        .isFalse();
                world.tell(BOAT, boat -> boat.handOver().takeCommand());
                Await.until(
                        "it has its own path again",
                        MISSION_S,
                        () -> isSame(
                                other.held(ID, HeldKind.MISSION)
                                        .exceptionally(busy -> List.of())
                                        .join(),
                                ours));
            }
            assertThat(world.faults).isEmpty();
        }
    }

    private static boolean isSame(List<MissionItem> one, List<MissionItem> other) {
        return one.size() == other.size()
                && IntStream.range(1, one.size())
                        .allMatch(number -> one.get(number).isSameAs(other.get(number)));
    }

    @Test
    void stopsByItselfAtANoGoAreaOfTheSession() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            connect(world);
            GeoPoint start = start(world);
            world.keepTo(Optional.of(area(start, -100, -100, 200)), List.of(area(start, 20, -20, 40)));
            untilParameter("FENCE_ENABLE", 1);
            List<GeoPoint> path = List.of(off(start, 10, 0), off(start, 40, 0), off(start, 80, 0));
            submit(world, FollowPath.of("through", 1, 1, path, Priority.MEDIUM));
            Await.until(
                    "it has stopped before the area",
                    MISSION_S,
                    () -> world.is(BOAT, boat -> isStill(boat) && metresNorth(start, boat) > 8));
            assertThat(world.<Double>ask(BOAT, boat -> metresNorth(start, boat)))
                    .isLessThan(20);

            world.keepTo(Optional.empty(), List.of(area(start, -40, -50, 100))); // around it
            Await.until(
                    "it says so",
                    MISSION_S,
                    () -> world.alarms.contains(BOAT + " says that it is outside of its own fence"));
            Await.until("its failsafe has taken it", MISSION_S, () -> world.is(BOAT, boat -> !boat.isCommanding()));
            assertThat(world.alarms).anyMatch(alarm -> alarm.startsWith(BOAT + " is taken by its own failsafe"));
        }
    }

    private static void untilParameter(String name, double value) {
        try (MavlinkBase other = otherStation()) {
            Await.until(
                    name + " is " + value,
                    MISSION_S,
                    () -> other.parameter(ID, name).join() == value);
        }
    }

    /** Another ground station on its third link, which hears it. */
    private static MavlinkBase otherStation() {
        MavlinkAddress address = AddressText.parse("mavlink:tcp:127.0.0.1:" + (ArduPilotBoats.secondPort(NUMBER) + 1));
        MavlinkBase other = new MavlinkBase(List.of(address), ProcessClock::ms);
        Await.until("it is heard", () -> !other.vehicles().join().isEmpty());
        return other;
    }

    private static boolean isStill(BoatProxy boat) {
        return boat.status().pose().orElseThrow().speedMps() < 0.05;
    }

    private static double metresNorth(GeoPoint start, BoatProxy boat) {
        return (boat.status().pose().orElseThrow().position().latDeg() - start.latDeg()) * 111_319;
    }

    private static GeoArea area(GeoPoint from, double northM, double eastM, double sizeM) {
        return new GeoArea(
                List.of(
                        off(from, northM, eastM),
                        off(from, northM, eastM + sizeM),
                        off(from, northM + sizeM, eastM + sizeM),
                        off(from, northM + sizeM, eastM)),
                List.of());
    }

    private static void connect(GatewayWorld world) {
        world.connect(ArduPilotBoats.address(NUMBER));
        Await.until(
                "it is ready",
                BOOT_S,
                () -> world.is(
                        BOAT,
                        boat -> boat.isCommanding() && boat.status().pose().isPresent()));
    }

    private static GeoPoint start(GatewayWorld world) {
        return world.ask(BOAT, boat -> boat.status().pose().orElseThrow().position());
    }

    private static GeoPoint off(GeoPoint from, double northM, double eastM) {
        double degree = 111_319;
        return GeoPoint.of(
                from.latDeg() + northM / degree,
                from.lonDeg() + eastM / (degree * Math.cos(Math.toRadians(from.latDeg()))));
    }

    private static void submit(GatewayWorld world, FollowPath path) {
        world.tell(BOAT, boat -> boat.commands().submit(path));
    }

    private static void completes(GatewayWorld world, String command) {
        Await.until(
                command + " is over",
                MISSION_S,
                () -> world.has(
                                FleetEvent.CommandCompleted.class,
                                done -> done.command().commandId().equals(command))
                        || world.has(FleetEvent.CommandFailed.class, failed -> {
                            throw new AssertionError(failed.reason());
                        }));
    }
}
