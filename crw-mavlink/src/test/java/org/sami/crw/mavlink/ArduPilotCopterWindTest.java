package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.ArduPilotBoats;

/** The wind as the real firmware of a copter estimates it in the air, by its drag. */
@Tag("long")
@Timeout(900)
class ArduPilotCopterWindTest {
    private static final int NUMBER = 110;
    private static final int SPEED = 5;
    private static final double FLIGHT_S = 300;
    private static final double WEAK_MPS = 3;
    private static final double DEGREE_M = 111_319;
    private static final String OF_ITS_OWNER = """
            EK3_DRAG_BCOEF_X 15
            EK3_DRAG_BCOEF_Y 15
            EK3_DRAG_MCOEF 0.2
            SIM_WIND_SPD 9
            SIM_WIND_DIR 180
            """;

    @TempDir
    private Path work;

    @Test
    void windThatItEstimatesInTheAirIsAReadingOfIt() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        Path own = Files.writeString(work.resolve("own.parm"), OF_ITS_OWNER);
        try (ArduPilotBoats copter = ArduPilotBoats.of("copter", NUMBER, SPEED, work, own)) {
            LinkClient client =
                    new LinkClient(work.resolve("vehicles"), ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
            try {
                Await.until(
                        "it says where it is",
                        FLIGHT_S,
                        () -> client.last(Telemetry.class).isPresent());
                Telemetry start = client.last(Telemetry.class).orElseThrow();
                List<Waypoint> out = List.of(north(start, 0), north(start, 60), north(start, 0), north(start, 60));
                assertThat(client.ask(new UploadWaypoints("upload", "out", out)))
                        .isInstanceOf(Ack.class);
                assertThat(client.ask(new StartWaypoints("start", "out", 0))).isInstanceOf(Ack.class);

                Await.until(
                        "it reports more than a weak wind",
                        FLIGHT_S,
                        () -> client.hasHeard(said -> said instanceof SensorReport report
                                && report.channel().equals("wind")
                                && report.unit().equals("m/s")
                                && report.values().get(0) > WEAK_MPS));
            } finally {
                client.close();
            }
        }
    }

    private static Waypoint north(Telemetry from, double metres) {
        return new Waypoint(from.latDeg() + metres / DEGREE_M, from.lonDeg(), 8, 20);
    }
}
