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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Telemetry;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.ArduPilotBoats;

/** The real firmware of boats and copters with and without a camera. */
@Tag("long")
@Timeout(900)
class ArduPilotCameraTest {
    private static final int NUMBER = 88;
    private static final int SPEED = 5;
    private static final double DEGREE_M = 111_319;

    @TempDir
    private Path work;

    private LinkClient connect() {
        return new LinkClient(work.resolve("vehicles"), ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
    }

    private ArduPilotBoats start(String kind, String parameters) throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        Path file = Files.writeString(work.resolve("camera.parm"), parameters);
        return ArduPilotBoats.of(kind, NUMBER, SPEED, work, file);
    }

    @ParameterizedTest
    @ValueSource(strings = {"boat", "copter"})
    void takesAPictureWhereItIs(String kind) throws Exception {
        try (ArduPilotBoats vehicle = start(kind, "CAM1_TYPE 1\nSERVO9_FUNCTION 10\n");
                LinkClient client = connect()) {
            assertTakes(client, "first");
            assertTakes(client, "second");

            Await.until("both are reported", () -> client.count(PanoramaReport.class) == 2);
            Telemetry here = client.last(Telemetry.class).orElseThrow();
            PanoramaReport report = client.last(PanoramaReport.class).orElseThrow();
            assertThat(report.pictures()).isEqualTo(1);
            assertThat(Math.abs(report.latDeg() - here.latDeg()) * DEGREE_M).isLessThan(10);
            assertThat(client.hasHeard(message -> isPicture(message, 2))).isTrue();
        }
    }

    private static void assertTakes(LinkClient client, String command) throws Exception {
        LinkMessage answer = client.ask(new TakePanorama(command, 8));
        assertThat(answer)
                .as(() -> answer instanceof Nack nack ? nack.detail() : command)
                .isInstanceOf(Ack.class);
    }

    private static boolean isPicture(LinkMessage message, double number) {
        return message instanceof SensorReport report
                && report.sensor().equals("camera")
                && report.values().equals(List.of(number));
    }

    @Test
    void saysThatItHasNone() throws Exception {
        try (ArduPilotBoats vehicle = start("boat", "CAM1_TYPE 0\n");
                LinkClient client = connect()) {
            LinkMessage answer = client.ask(new TakePanorama("asked", 8));

            assertThat(answer).isInstanceOfSatisfying(Nack.class, nack -> {
                assertThat(nack.reason()).isEqualTo(NackReason.NO_CAMERA);
                assertThat(nack.detail()).contains("has no camera (CAM1_TYPE 0)");
            });
        }
    }
}
