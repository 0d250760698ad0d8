package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.mavlink.testing.TcpRelay;

/** A copter on the ground that goes on in the midst of a path that is longer than what its firmware holds; where it truly was, its simulator says. */
@Tag("long")
@Timeout(900)
class ArduPilotCopterTakeOffTest {
    private static final int NUMBER = 120;
    private static final int SPEED = 5;
    private static final double FLIGHT_S = 300;
    private static final double RADIUS_M = 3;
    private static final double DEGREE_M = 111_319;
    private static final int LOCATIONS = 700;
    private static final double APART_M = 4;
    private static final int FROM = 650;
    private static final int NEAR = 400; // in the part that is sent first
    private static final double HEIGHT_M = 20;
    private static final double BESIDE_M = 40;

    @TempDir
    private Path work;

    @Test
    void climbsFliesOnFromThereAndVisitsNothingBeforeThat() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats copters = ArduPilotBoats.copters(NUMBER, 1, SPEED, work)) {
            LinkClient client = base(ArduPilotBoats.address(NUMBER));
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                Telemetry ground = now(client);
                List<Waypoint> path = path(ground, NEAR);
                upload(client, path);
                start(client, "start", NEAR);
                assertThat(now(client).altM().orElseThrow()).isLessThan(HEIGHT_M / 2);

                assertThat(client.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);
                Await.until("it keeps its place", FLIGHT_S, () -> now(client).mode() == BoatMode.HOLD);
                int stopped = truth.samples();
                Await.until("it hangs there for 10 s of its time", FLIGHT_S, () -> truth.samples() > stopped + 100);
                assertThat(now(client).altM().orElseThrow()).isBetween(0.5, HEIGHT_M - 5);
                assertThat(now(client).mode()).isEqualTo(BoatMode.HOLD);

                start(client, "again", NEAR);
                Await.until("it is up", FLIGHT_S, () -> now(client).altM().orElseThrow() > HEIGHT_M - 2);
                assertThat(metres(ground, now(client))).as("while it climbs").isLessThan(RADIUS_M);
                passes(client, NEAR + 100);

                assertThat(path.subList(NEAR, NEAR + 100))
                        .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                                .isLessThan(RADIUS_M));
                assertThat(path.subList(0, NEAR - 5))
                        .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                                .isGreaterThan(4 * APART_M));
                assertThat(client.isObserver()).isFalse();
                assertThat(client.alarms("does not go on")).isEmpty();
            } finally {
                client.close();
            }
        }
    }

    @Test
    void baseThatIsKilledDuringTheClimbLeavesItAboveUntilTheNextOneSendsItOn() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats copters = ArduPilotBoats.copters(NUMBER, 1, SPEED, work);
                TcpRelay firstWay = new TcpRelay(ArduPilotBoats.firstPort(NUMBER));
                TcpRelay secondWay = new TcpRelay(ArduPilotBoats.firstPort(NUMBER))) {
            LinkClient first = base(firstWay.address());
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                Telemetry ground = now(first);
                List<Waypoint> path = path(ground, FROM);
                upload(first, path);
                start(first, "start", FROM);
                firstWay.cut(true); // nothing that the base does at its end comes through
                first.close();
                firstWay.close();

                goesOn(base(secondWay.address()), truth, ground, path);
            } finally {
                first.close();
            }
        }
    }

    private static void goesOn(LinkClient second, SimulatorTruth truth, Telemetry ground, List<Waypoint> path) {
        try {
            Await.until("it is up", FLIGHT_S, () -> now(second).altM().orElseThrow() > HEIGHT_M - 1);
            int up = truth.samples();
            Await.until("it waits for 20 s of its time", FLIGHT_S, () -> truth.samples() > up + 200);
            assertThat(now(second).altM().orElseThrow()).isBetween(HEIGHT_M - 1, HEIGHT_M + 1);
            assertThat(metres(ground, now(second))).isLessThan(RADIUS_M);

            assertThat(second.ask(new ReadBack("read again")))
                    .isInstanceOfSatisfying(
                            HeldWaypoints.class,
                            held -> assertThat(held.waypoints()).isEqualTo(path));
            start(second, "again", FROM);
            passes(second, LOCATIONS);

            assertThat(path.subList(FROM, LOCATIONS))
                    .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                            .isLessThan(RADIUS_M));
            assertThat(path.subList(0, FROM - 5))
                    .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                            .isGreaterThan(4 * APART_M));
            assertThat(now(second).altM().orElseThrow()).isGreaterThan(HEIGHT_M - 1);
        } finally {
            second.close();
        }
    }

    private LinkClient base(String address) {
        return new LinkClient(work.resolve("vehicles"), address + "/" + (NUMBER + 1));
    }

    /** To the north, beside the copter, which is level with one of its places. */
    private static List<Waypoint> path(Telemetry from, int level) {
        double narrower = Math.cos(Math.toRadians(from.latDeg()));
        return IntStream.range(0, LOCATIONS)
                .mapToObj(i -> new Waypoint(
                        from.latDeg() + (i - level) * APART_M / DEGREE_M,
                        from.lonDeg() + BESIDE_M / (DEGREE_M * narrower),
                        8,
                        HEIGHT_M))
                .toList();
    }

    private static void upload(LinkClient client, List<Waypoint> path) {
        assertThat(client.ask(new UploadWaypoints("upload", "path", path))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read"))).isInstanceOf(HeldWaypoints.class);
    }

    private static void start(LinkClient client, String name, int from) {
        assertThat(client.ask(new StartWaypoints(name, "path", from))).isInstanceOf(Ack.class);
    }

    private static void passes(LinkClient client, int waypoints) {
        Await.until(
                waypoints + " places are passed",
                FLIGHT_S,
                () -> client.last(Progress.class).orElseThrow().nextIndex() >= waypoints);
    }

    private static double metres(Telemetry from, Telemetry to) {
        double narrower = Math.cos(Math.toRadians(from.latDeg()));
        return DEGREE_M * Math.hypot(to.latDeg() - from.latDeg(), (to.lonDeg() - from.lonDeg()) * narrower);
    }

    private static Telemetry now(LinkClient client) {
        return client.last(Telemetry.class).orElseThrow();
    }
}
