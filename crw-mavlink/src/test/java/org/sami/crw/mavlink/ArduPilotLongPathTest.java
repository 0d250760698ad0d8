package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.spn.value.GeoPoint;

/** A path that is longer than what the real firmware holds; with {@code -PvehicleMissions}, as it takes minutes. */
@Timeout(1200)
class ArduPilotLongPathTest {
    private static final int NUMBER = 91;
    private static final int SPEED = 10;
    private static final double MISSION_S = 500;
    private static final double RADIUS_M = 3;
    private static final int LONG_PATH = 1_000;
    private static final int LANE = 20; // locations
    private static final double STAY_S = 20; // simulated time within the radius: 12 s where it turns

    @TempDir
    private Path work;

    @Test
    void followsAPathThatIsLongerThanWhatItHoldsOverTheDeathOfABase() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work)) {
            LinkClient client = linked();
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                Telemetry at = client.last(Telemetry.class).orElseThrow();
                GeoPoint start = GeoPoint.of(at.latDeg(), at.lonDeg());
                List<Waypoint> path = IntStream.range(0, LONG_PATH)
                        .mapToObj(i -> onLanes(start, i / LANE, i % LANE))
                        .map(place -> new Waypoint(place.latDeg(), place.lonDeg(), 1.5))
                        .toList();
                assertThat(client.ask(new UploadWaypoints("upload", "long", path)))
                        .isInstanceOf(Ack.class);
                drive("first", 0, path, client);
                int first = samplesAt(1, client, truth);
                samplesAt(LONG_PATH / 2, client, truth);
                client.close();
                int died = truth.samples();
                Await.until("it drives on for a minute", () -> truth.samples() > died + 600);

                client = linked();
                drive("second", LONG_PATH / 2, path, client);
                int last = samplesAt(LONG_PATH - 10, client, truth);
                samplesAt(LONG_PATH, client, truth);

                assertThat(path)
                        .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                                .isLessThan(RADIUS_M));
                assertThat(truth.longestStayS(first, last, RADIUS_M)).isLessThan(STAY_S);
            } finally {
                client.close();
            }
        }
    }

    private LinkClient linked() {
        return new LinkClient(work.resolve("vehicles"), ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
    }

    /** Has it drive from where it is, if that is not before a waypoint. */
    private static void drive(String name, int least, List<Waypoint> path, LinkClient client) {
        assertThat(client.ask(new ReadBack("read " + name)))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class,
                        held -> assertThat(held.waypoints()).isEqualTo(path));
        int next = client.last(Progress.class).orElseThrow().nextIndex();
        assertThat(next).isGreaterThanOrEqualTo(least);
        assertThat(client.ask(new StartWaypoints("start " + name, "long", next)))
                .isInstanceOf(Ack.class);
    }

    private static int samplesAt(int visited, LinkClient client, SimulatorTruth truth) {
        Await.until(
                visited + " locations are visited",
                MISSION_S,
                () -> client.last(Progress.class).orElseThrow().nextIndex() >= visited);
        return truth.samples();
    }

    /** Lanes to and fro, 8 m apart. */
    private static GeoPoint onLanes(GeoPoint start, int lane, int place) {
        return off(start, 10 + 8.0 * lane, 3.0 * (lane % 2 == 0 ? place : LANE - 1 - place));
    }

    private static GeoPoint off(GeoPoint from, double northM, double eastM) {
        double degree = 111_319;
        return GeoPoint.of(
                from.latDeg() + northM / degree,
                from.lonDeg() + eastM / (degree * Math.cos(Math.toRadians(from.latDeg()))));
    }
}
