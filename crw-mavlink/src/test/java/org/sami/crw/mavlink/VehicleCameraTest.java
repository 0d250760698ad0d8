package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.Panorama;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;

@Timeout(300)
class VehicleCameraTest {
    private static final double LAT = 45.7;
    private static final double LON = 10.72;
    private static final Offset<Double> NEAR = Offset.offset(1e-7);
    private static final String TYPE = "CAM1_TYPE";

    @TempDir
    private Path folder;

    private SmallBoat boat;

    @BeforeEach
    void begin() throws Exception {
        boat = new SmallBoat(7, LAT, LON, 20);
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
    }

    private static void assertRefused(LinkMessage answer, NackReason reason, String words) {
        assertThat(answer).isInstanceOfSatisfying(Nack.class, nack -> {
            assertThat(nack.reason()).isEqualTo(reason);
            assertThat(nack.detail()).contains(words);
        });
    }

    @Test
    void eachOrderIsOnePictureWithItsPlaceAndNumber() {
        boat.parameter(TYPE, 1);
        try (LinkClient client = new LinkClient(folder, boat.address() + "/7")) {
            assertThat(client.ask(new TakePanorama("first", 8))).isInstanceOf(Ack.class);
            assertThat(client.ask(new TakePanorama("second", 8))).isInstanceOf(Ack.class);

            Await.until("both are reported", () -> client.count(PanoramaReport.class) == 2);
            assertThat(client.last(PanoramaReport.class)).hasValueSatisfying(report -> {
                assertThat(report.commandId()).isEqualTo("second");
                assertThat(report.pictures()).isEqualTo(1);
                assertThat(report.files()).isEmpty();
                assertThat(report.latDeg()).isCloseTo(LAT, NEAR);
                assertThat(report.lonDeg()).isCloseTo(LON, NEAR);
            });
            assertThat(client.last(SensorReport.class)).hasValueSatisfying(number -> {
                assertThat(number.sensor() + "/" + number.channel()).isEqualTo("camera/picture");
                assertThat(number.values()).containsExactly(2.0);
                assertThat(number.latDeg()).isCloseTo(LAT, NEAR);
                assertThat(number.lonDeg()).isCloseTo(LON, NEAR);
            });
        }
    }

    @Test
    void boatWithoutACameraSaysSo() {
        try (LinkClient client = new LinkClient(folder, boat.address() + "/7")) {
            assertRefused(
                    client.ask(new TakePanorama("asked", 8)),
                    NackReason.NO_CAMERA,
                    "vehicle 7 has no camera (CAM1_TYPE 0)");
        }
    }

    @Test
    void acceptedOrderWithoutAReportedPictureHasFailed() {
        boat.parameter(TYPE, 1);
        boat.faults().jamCamera(true);
        try (LinkClient client = new LinkClient(folder, boat.address() + "/7")) {
            assertRefused(
                    client.ask(new TakePanorama("asked", 8)), NackReason.NOT_ABLE, "does not report one within 5 s");

            boat.faults().jamCamera(false);
            assertThat(client.ask(new TakePanorama("again", 8))).isInstanceOf(Ack.class);
            Await.until("the one is reported", () -> client.count(PanoramaReport.class) == 1);
        }
    }

    @Test
    void cameraThatIsAtItsLastPictureStillIsAskedAgain() {
        boat.parameter(TYPE, 1);
        try (LinkClient client = new LinkClient(folder, boat.address() + "/7")) {
            boat.faults().cameraBusy(2);
            assertThat(client.ask(new TakePanorama("asked", 8))).isInstanceOf(Ack.class);
            Await.until("it is reported", () -> client.count(PanoramaReport.class) == 1);
        }
    }

    @Test
    void cameraThatFailsAgainAndAgainIsNotAskedForever() {
        boat.parameter(TYPE, 1);
        try (LinkClient client = new LinkClient(folder, boat.address() + "/7")) {
            boat.faults().cameraBusy(1_000);
            assertRefused(
                    client.ask(new TakePanorama("asked", 8)), NackReason.NOT_ABLE, "vehicle 7 fails to take a picture");
        }
    }

    @Test
    void baseKnowsWhetherThereIsOneAndHearsOfThePicture() throws Exception {
        boat.parameter(TYPE, 1);
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address());
            world.untilReady("mav7");
            world.until(
                    "it can take pictures",
                    "mav7",
                    proxy -> !proxy.capabilities().cannot().containsKey(BoatCapabilities.PANORAMA));

            Panorama panorama = new Panorama("m1-a1-mav7", 1, 1, 8, Priority.MEDIUM);
            world.tell("mav7", proxy -> proxy.commands().submit(panorama));

            Await.until(
                    "the picture is taken",
                    () -> world.has(
                            FleetEvent.PanoramaTaken.class,
                            taken -> taken.command().equals(panorama) && taken.pictures() == 1));
            assertThat(world.faults).isEmpty();
        }
    }

    @Test
    void cameraThatIsSwitchedOnWithARestartOfTheAutopilotIsKnown() throws Exception {
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address());
            world.untilReady("mav7");
            world.until(
                    "it has none",
                    "mav7",
                    proxy -> proxy.capabilities()
                            .cannot()
                            .getOrDefault(BoatCapabilities.PANORAMA, "")
                            .contains("CAM1_TYPE 0"));

            boat.parameter(TYPE, 1);
            boat.restart();

            world.until(
                    "it has one",
                    "mav7",
                    proxy -> !proxy.capabilities().cannot().containsKey(BoatCapabilities.PANORAMA));
        }
    }
}
