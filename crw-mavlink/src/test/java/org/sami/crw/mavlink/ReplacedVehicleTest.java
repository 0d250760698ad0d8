package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Another vehicle comes with the system id of one that is connected, or was: on the same port, as autopilots are switched off and on. */
@Timeout(600)
class ReplacedVehicleTest {
    private static final double LAT = 45.7;
    private static final double LON = 10.72;
    private static final double TIMES = 10;
    private static final double HEIGHT_M = 20;
    private static final List<GeoPoint> PATH = List.of(new GeoPoint(LAT, LON, 0), new GeoPoint(45.8, LON, 0));

    private static final int ANSWERS = 5; // so that a mission is read, and begun to be sent
    private static final List<Waypoint> MANY = IntStream.range(0, 40)
            .mapToObj(i -> new Waypoint(LAT + i * 1e-4, LON, 1))
            .toList();

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
        Await.until("its link is lost", this::isSilent);
    }

    private boolean isSilent() {
        List<LinkStatus> links = client.linkStatuses(); // none before the first report
        return !links.isEmpty() && links.stream().noneMatch(LinkStatus::isGood);
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
            String words =
                    "mav7 was a surface boat, and a copter answers with its number now on " + boat.address() + ". ";
            Await.until("the operator is told, or it falls", () -> copter.fell() || client.hasAlarm(words));

            assertThat(copter.fell()).isFalse();
            assertThat(client.said(words, Priority.CRITICAL))
                    .hasSize(1)
                    .allMatch(text -> RobotKind.COPTER.say(text).startsWith(words))
                    .allMatch(text -> RobotKind.ROBOT.say(text).startsWith(words));
        }
    }

    @Test
    void copterWithTheNumberOfABoatIsConnectedAsACopter() throws Exception {
        switchBoatOff();
        try (SmallCopter copter = copterInTheAir()) {
            client.untilAlarm("mav7 was a surface boat");
            client.reconnect();
            assertThat(client.ask(new FleetStop("fleet stop"))).isInstanceOf(Ack.class);

            assertThat(copter.mode()).isEqualTo(SmallCopter.BRAKE);
            assertThat(copter.isArmed()).isTrue();
            assertThat(copter.fell()).isFalse();
        }
    }

    @Test
    void missionThatIsBeingSentToABoatDoesNotReachACopterWithItsNumber() throws Exception {
        boat.faults().answersAboutMissions(ANSWERS);
        client.say(new UploadWaypoints("upload", "path", MANY));
        Await.until("it is under way", () -> boat.faults().answersLeft() == 0);
        assertThat(boat.mission().uploads()).isZero();
        switchBoatOff();
        try (SmallCopter copter = copterInTheAir()) {
            client.untilAlarm("mav7 was a surface boat, and a copter answers with its number now");

            Await.holds(
                    "it is sent nothing",
                    3,
                    () -> copter.mission().size() == 0 && copter.mission().uploads() == 0);
        }
    }

    @Test
    void missionOfABoatIsNotGoneOnWithByAnotherBoatWithItsNumber() throws Exception {
        client.close();
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address() + "/7");
            world.untilReady("mav7");
            world.tell("mav7", proxy -> proxy.commands().submit(FollowPath.of("path", 1, 1, PATH, Priority.MEDIUM)));
            Await.until("it sets off", GatewayWorld.WAIT_S, boat::isArmed);
            boat.close();
            try (SmallBoat another = anotherBoat()) {
                another.restart(); // it has just been switched on
                another.parameter("STAT_BOOTCNT", 41); // as often as the one before
                Await.until(
                        "the operator is told",
                        GatewayWorld.WAIT_S,
                        () -> world.alarms.stream()
                                .anyMatch(text ->
                                        text.startsWith("another surface boat answers with the number of mav7 on ")));
                Await.until(
                        "it may not move yet",
                        GatewayWorld.WAIT_S,
                        () -> world.has(FleetEvent.Restarted.class, event -> true));
                world.untilReady("mav7");

                assertThat(another.armings()).isZero();
                assertThat(another.orderedModes()).isEmpty();
            }
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
                "mav7 is another surface boat than the last one with its number: the list, the consumption and the fence of"
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
