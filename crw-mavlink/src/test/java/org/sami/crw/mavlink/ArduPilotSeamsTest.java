package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
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
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;

/**
 * How fast the real firmware truly drives where the parts of a long path meet, and while they are sent, compared with its turns; with {@code -PvehicleMissions},
 * as it takes minutes. The path leads straight where parts meet, so that a turn is not taken for a stop; another one leads straight all the way, so that no turn
 * comes at which a part costs nothing.
 */
@Timeout(1200)
class ArduPilotSeamsTest {
    private static final int NUMBER = 106;
    private static final int SPEED = 10;
    private static final int LOCATIONS = 2_000;
    private static final int LANE = 230; // locations; no turn is nearer than 20 m to where parts meet
    private static final double APART_M = 3;
    private static final double LANES_M = 12;
    private static final double MPS = 3;
    private static final double NEAR_M = 12;
    private static final double SLOW_MPS = 0.9;
    private static final double STANDS_MPS = 0.3;
    private static final int WINDOW = 5; // reports, half a second
    private static final double REPORT_S = 0.1;
    private static final int BEFORE_ITS_FIRST = 2; // items: home, and the speed
    private static final double MISSION_S = 900;
    private static final int AHEAD = 720; // locations of the straight path, until two parts more are there
    private static final double APART_S = 2; // what is slow within that time is one stop

    @TempDir
    private Path work;

    @Test
    void doesNotStopOnStraightWays() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work)) {
            LinkClient client = linked();
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                Telemetry at = client.last(Telemetry.class).orElseThrow();
                LocalFrame start = new LocalFrame(at.latDeg(), at.lonDeg());
                drive(client, start, ArduPilotSeamsTest::place);
                compare(track(client, start, truth, LOCATIONS - 5));
                assertThat(truth.gap()).isEmpty();
            } finally {
                client.close();
            }
        }
    }

    @Test
    void slowsDownAtMostOnceForEachPartOfAPathWithoutTurns() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work)) {
            assertThat(slowOnAStraightPath()).hasSizeLessThanOrEqualTo(2);
        }
    }

    /** ArduPilot with a memory card for more than 4,300 items. */
    @Test
    void neverSlowsDownWhereItHoldsTheWholePath() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = ArduPilotBoats.with("BRD_SD_MISSION 64\n", NUMBER, 1, SPEED, work)) {
            assertThat(slowOnAStraightPath()).isEmpty();
        }
    }

    /** The lowest speed in half a second of each time at which it was slow, in m/s. */
    private List<Double> slowOnAStraightPath() throws Exception {
        LinkClient client = linked();
        try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
            Telemetry at = client.last(Telemetry.class).orElseThrow();
            LocalFrame start = new LocalFrame(at.latDeg(), at.lonDeg());
            drive(client, start, location -> new double[] {APART_M * location, 10});
            List<double[]> track = track(client, start, truth, AHEAD);
            assertThat(truth.gap()).isEmpty();
            return slowTimes(track);
        } finally {
            client.close();
        }
    }

    private static List<Double> slowTimes(List<double[]> track) {
        List<Double> lowest = new ArrayList<>();
        int before = -1;
        List<Double> all = new ArrayList<>();
        for (int i = 0; i + WINDOW < track.size(); i++) {
            double mps = mps(track.get(i), track.get(i + WINDOW));
            all.add(mps);
            if (mps < SLOW_MPS) {
                if (before < 0 || (i - before) * REPORT_S > APART_S) {
                    lowest.add(mps);
                    System.out.printf(Locale.ROOT, "slow after %.1f s, %.0f m east%n", i * REPORT_S, track.get(i)[0]);
                }
                lowest.set(lowest.size() - 1, Math.min(mps, lowest.get(lowest.size() - 1)));
                before = i;
            }
        }
        long stands = all.stream().filter(mps -> mps < STANDS_MPS).count();
        System.out.printf(
                Locale.ROOT,
                "on a straight path of %d locations: lowest speeds %s m/s, usually %.2f m/s, %.1f s below %.1f m/s, %.1f s"
                        + " below %.1f m/s, %d reports%n",
                AHEAD,
                lowest,
                all.stream().sorted().skip(all.size() / 2).findFirst().orElse(0.0),
                stands * REPORT_S,
                STANDS_MPS,
                all.stream().filter(mps -> mps < SLOW_MPS).count() * REPORT_S,
                SLOW_MPS,
                track.size());
        return lowest;
    }

    private LinkClient linked() {
        return new LinkClient(work.resolve("vehicles"), ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
    }

    /** Its places from the fifth location to another one: metres east and north. */
    private static List<double[]> track(LinkClient client, LocalFrame start, SimulatorTruth truth, int to) {
        Await.until("it has come out", MISSION_S, () -> visited(client) >= 5);
        int first = truth.samples();
        Await.until("it is there", MISSION_S, () -> visited(client) >= to);
        return truth.placesFrom(first).stream()
                .map(place -> new double[] {start.eastM(place[0], place[1]), start.northM(place[0], place[1])})
                .toList();
    }

    private static double mps(double[] from, double[] to) {
        return Math.hypot(to[0] - from[0], to[1] - from[1]) / (WINDOW * REPORT_S);
    }

    private static int visited(LinkClient client) {
        return client.last(Progress.class).orElseThrow().nextIndex();
    }

    private static void drive(LinkClient client, LocalFrame start, IntFunction<double[]> places) {
        List<Waypoint> path = IntStream.range(0, LOCATIONS)
                .mapToObj(places)
                .map(place -> new Waypoint(start.latDeg(place[0], place[1]), start.lonDeg(place[0], place[1]), MPS))
                .toList();
        assertThat(client.ask(new UploadWaypoints("upload", "long", path))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read"))).isInstanceOf(HeldWaypoints.class);
        assertThat(client.ask(new StartWaypoints("start", "long", 0))).isInstanceOf(Ack.class);
    }

    /** Lanes to and fro: metres east and north. */
    private static double[] place(int location) {
        int lane = location / LANE;
        int along = lane % 2 == 0 ? location % LANE : LANE - 1 - location % LANE;
        return new double[] {APART_M * along, 10 + LANES_M * lane};
    }

    private static void compare(List<double[]> track) {
        List<double[]> meet = IntStream.iterate(
                        MissionWindow.SLOTS, item -> item < LOCATIONS, item -> item + MissionWindow.STEP)
                .mapToObj(item -> place(item - BEFORE_ITS_FIRST))
                .toList();
        List<double[]> turns = IntStream.range(1, LOCATIONS - 1)
                .filter(location -> location % LANE == 0 || location % LANE == LANE - 1)
                .mapToObj(ArduPilotSeamsTest::place)
                .toList();
        List<Double> met = new ArrayList<>();
        List<Double> turned = new ArrayList<>();
        List<Double> straight = new ArrayList<>();
        List<String> slow = new ArrayList<>();
        for (int i = 0; i + WINDOW < track.size(); i++) {
            double[] now = track.get(i);
            double[] then = track.get(i + WINDOW);
            double mps = mps(now, then);
            if (isNear(now, turns)) {
                turned.add(mps);
            } else {
                (isNear(now, meet) ? met : straight).add(mps);
                if (mps < SLOW_MPS) {
                    slow.add(String.format(
                            Locale.ROOT,
                            "%.2f m/s after %.1f s, %.1f m east, %.1f m north",
                            mps,
                            i * REPORT_S,
                            now[0],
                            now[1]));
                }
            }
        }
        System.out.printf(
                Locale.ROOT,
                "slowest in half a second: %.2f m/s near %d places where parts meet (%d reports), %.2f m/s elsewhere on"
                        + " straight ways (%d, usually %.2f m/s), %.2f m/s at %d turns by 90 degrees (%d)%n",
                slowest(met),
                meet.size(),
                met.size(),
                slowest(straight),
                straight.size(),
                straight.stream().sorted().skip(straight.size() / 2).findFirst().orElse(0.0),
                slowest(turned),
                turns.size(),
                turned.size());
        slow.forEach(System.out::println);
        double straightS = longestStandS(track, turns, false);
        System.out.printf(
                Locale.ROOT,
                "below %.1f m/s for %.1f s at most on straight ways, %.1f s at turns%n",
                STANDS_MPS,
                straightS,
                longestStandS(track, turns, true));
        assertThat(slowest(met)).isGreaterThan(SLOW_MPS);
        assertThat(straightS).as("seconds for which it stood on a straight way").isZero();
    }

    private static double longestStandS(List<double[]> track, List<double[]> turns, boolean atTurns) {
        int longest = 0;
        int now = 0;
        for (int i = 0; i + WINDOW < track.size(); i++) {
            double[] from = track.get(i);
            double[] to = track.get(i + WINDOW);
            boolean stands = Math.hypot(to[0] - from[0], to[1] - from[1]) < STANDS_MPS * WINDOW * REPORT_S;
            now = stands && isNear(from, turns) == atTurns ? now + 1 : 0;
            longest = Math.max(longest, now);
        }
        return longest * REPORT_S;
    }

    private static double slowest(List<Double> speeds) {
        return speeds.stream().mapToDouble(mps -> mps).min().orElse(0);
    }

    private static boolean isNear(double[] at, List<double[]> places) {
        return places.stream().anyMatch(place -> Math.hypot(at[0] - place[0], at[1] - place[1]) <= NEAR_M);
    }
}
