package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.spn.protocol.Priority;

/** Another vehicle comes with the system id of one that is connected, or was: on the same port, as autopilots are switched off and on. */
@Timeout(600)
class ReplacedVehicleTest {
    private static final double LAT = 45.7;
    private static final double LON = 10.72;
    private static final double TIMES = 10;
    private static final double HEIGHT_M = 20;
    private static final List<Waypoint> PATH = List.of(new Waypoint(LAT, LON, 1), new Waypoint(45.8, LON, 1));

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;

    @BeforeEach
    void connect() throws Exception {
        boat = new SmallBoat(7, LAT, LON, TIMES);
        client = new LinkClient(folder, boat.address() + "/7");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    private void switchBoatOff() throws Exception {
        boat.close();
        Await.until("it is silent", () -> client.linkStatuses().stream().noneMatch(LinkStatus::isGood));
    }

    private SmallCopter copterInTheAir() throws Exception {
        return new SmallCopter(7, LAT, LON, TIMES, boat.port(), HEIGHT_M);
    }

    private SmallBoat anotherBoat() throws Exception {
        return new SmallBoat(7, LAT, LON, TIMES, boat.port());
    }

    @Test
    void stopOfABoatDoesNotHaveACopterWithItsNumberFall() throws Exception {
        switchBoatOff();
        client.say(new StopMotors("stop"));
        try (SmallCopter copter = copterInTheAir()) {
            String words = "mav7 was a boat, and a copter answers with its number now on " + boat.address() + ". ";
            Await.until("the operator is told, or it falls", () -> copter.fell() || client.hasAlarm(words));

            assertThat(copter.fell()).isFalse();
            assertThat(client.said(words, Priority.CRITICAL)).hasSize(1);
        }
    }

    @Test
    void copterWithTheNumberOfABoatIsConnectedAsACopter() throws Exception {
        switchBoatOff();
        try (SmallCopter copter = copterInTheAir()) {
            client.untilAlarm("mav7 was a boat");
            client.reconnect();
            assertThat(client.ask(new FleetStop("fleet stop"))).isInstanceOf(Ack.class);

            assertThat(copter.mode()).isEqualTo(SmallCopter.BRAKE);
            assertThat(copter.isArmed()).isTrue();
            assertThat(copter.fell()).isFalse();
        }
    }

    @Test
    void missionOfABoatIsNotGoneOnWithByAnotherBoatWithItsNumber() throws Exception {
        client.ask(new UploadWaypoints("upload", "list", PATH));
        client.ask(new StartWaypoints("start", "list", 0));
        String start = client.last(Welcome.class).orElseThrow().bootId();
        switchBoatOff();
        try (SmallBoat another = anotherBoat()) {
            client.reconnect();
            client.untilAlarm("another boat answers with the number of mav7");
            Await.until(
                    "it says where it is", () -> client.last(Telemetry.class).isPresent());

            assertThat(client.last(Welcome.class).orElseThrow().bootId()).isNotEqualTo(start);
            assertThat(another.armings()).isZero();
            assertThat(another.orderedModes()).isEmpty();
        }
    }

    @Test
    void fleetStopOfABoatIsKeptForItAndDoesNotCountForAnother() throws Exception {
        boat.number().set(501);
        client.close();
        client = new LinkClient(folder, boat.address() + "/7");
        client.ask(new FleetStop("stop"));
        client.close();
        boat.close();

        boat = new SmallBoat(7, LAT, LON, TIMES);
        client = new LinkClient(folder, boat.address() + "/7");
        client.untilAlarm(
                "mav7 is another boat than the last one with its number: the list, the consumption and the fence of"
                        + " that one are kept for it, also that it was stopped by client: this one is not stopped");
        assertThat(client.last(Telemetry.class).orElseThrow().mode()).isEqualTo(BoatMode.STOPPED);
        client.close();
        boat.close();

        boat = new SmallBoat(7, LAT, LON, TIMES);
        boat.number().set(501);
        client = new LinkClient(folder, boat.address() + "/7");
        assertThat(client.last(SettingsReport.class).orElseThrow().stoppedBy()).isEqualTo("client");
        assertThat(client.last(Telemetry.class).orElseThrow().mode()).isEqualTo(BoatMode.FLEET_STOP);
    }

    @Test
    void fleetStopOfABoatHoldsWhereItsNumberIsNotSaidAnyMore() throws Exception {
        client.ask(new FleetStop("stop"));
        client.close();
        boat.number().forget();

        client = new LinkClient(folder, boat.address() + "/7");
        assertThat(client.last(Telemetry.class).orElseThrow().mode()).isEqualTo(BoatMode.FLEET_STOP);
    }
}
