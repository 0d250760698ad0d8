package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;

/** The real firmware of a copter under a base's commands; where it truly was, its simulator says. */
@Tag("long")
@Timeout(900)
class ArduPilotCopterTest {
    private static final int NUMBER = 92;
    private static final int SPEED = 5;
    private static final double FLIGHT_S = 300;
    private static final double RADIUS_M = 3;
    private static final double DEGREE_M = 111_319;

    private static final double GROUND_M = 0.3; // as its barometer is simulated

    @TempDir
    private Path work;

    @Test
    void takesOffFliesAPathStopsInTheAirAndLandsUnderAnotherBase() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats copters = ArduPilotBoats.copters(NUMBER, 1, SPEED, work)) {
            LinkClient first = base(); // the firmware opens its second port once somebody is at the first
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                Telemetry start = now(first);
                assertThat(start.altM().orElseThrow()).isBetween(-GROUND_M, GROUND_M);

                List<Waypoint> out = List.of(off(start, 0, 20), off(start, 40, 20), off(start, 400, 25));
                fly(first, "out", out);
                Await.until("it has passed the second place", FLIGHT_S, () -> reached(first, "out", 2));
                assertThat(first.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);
                Await.until("it keeps its place", FLIGHT_S, () -> now(first).mode() == BoatMode.HOLD);
                assertThat(now(first).altM().orElseThrow()).isGreaterThan(15);
                assertThat(first.isObserver()).isFalse();
                first.close();

                landUnderAnotherBase(start);

                assertThat(truth.nearestM(out.get(1).latDeg(), out.get(1).lonDeg()))
                        .isLessThan(RADIUS_M);
            } finally {
                first.close();
            }
        }
    }

    private LinkClient base() {
        return new LinkClient(work.resolve("vehicles"), ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
    }

    private void landUnderAnotherBase(Telemetry start) {
        LinkClient second = base();
        try {
            Await.until(
                    "the base that meets it in the air reads its home",
                    FLIGHT_S,
                    () -> second.last(SettingsReport.class)
                            .flatMap(SettingsReport::home)
                            .isPresent());
            Waypoint home =
                    second.last(SettingsReport.class).orElseThrow().home().orElseThrow();
            assertThat(home.latDeg()).isCloseTo(start.latDeg(), within(RADIUS_M / DEGREE_M));
            assertThat(home.lonDeg()).isCloseTo(start.lonDeg(), within(RADIUS_M / DEGREE_M));

            fly(second, "back", List.of(off(start, 0, 20), off(start, 0, 0)));
            Await.until(
                    "it has landed",
                    FLIGHT_S,
                    () -> second.hasHeard(message ->
                            message instanceof Progress there && there.listId().equals("back") && there.completed()));
            assertThat(now(second).altM().orElseThrow()).isBetween(-GROUND_M, GROUND_M);
        } finally {
            second.close();
        }
    }

    private static Telemetry now(LinkClient client) {
        return client.last(Telemetry.class).orElseThrow();
    }

    private static boolean reached(LinkClient client, String list, int next) {
        return client.hasHeard(message ->
                message instanceof Progress progress && progress.listId().equals(list) && progress.nextIndex() >= next);
    }

    private static void fly(LinkClient client, String list, List<Waypoint> waypoints) {
        assertThat(client.ask(new UploadWaypoints("upload " + list, list, waypoints)))
                .isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("start " + list, list, 0))).isInstanceOf(Ack.class);
    }

    private static Waypoint off(Telemetry from, double northM, double altM) {
        return new Waypoint(from.latDeg() + northM / DEGREE_M, from.lonDeg(), 8, altM);
    }
}
