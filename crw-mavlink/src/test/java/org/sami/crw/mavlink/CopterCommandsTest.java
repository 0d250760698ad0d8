package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallCopter;

/** What a base asks of a copter, on a simulated one that is armed, takes off, lands and refuses as ArduPilot's copters do. */
@Timeout(900)
class CopterCommandsTest {
    private static final Waypoint UP = new Waypoint(45.7, 10.72, 8, 20);
    private static final Waypoint NORTH = new Waypoint(45.7004, 10.72, 8, 20);
    private static final Waypoint EAST = new Waypoint(45.7004, 10.7206, 5, 30);
    private static final Waypoint GROUND = new Waypoint(45.7004, 10.7206, 5, 0);
    private static final Waypoint FAR = new Waypoint(45.8, 10.72, 5, 20);

    private static final int SET_MODE = 176;

    @TempDir
    private Path folder;

    private SmallCopter copter;
    private LinkClient client;

    @BeforeEach
    void place() throws Exception {
        copter = new SmallCopter(6, 45.7, 10.72, 10);
        client = new LinkClient(folder, copter.address() + "/6");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        copter.close();
    }

    private LinkMessage upload(String list, Waypoint... waypoints) {
        return client.ask(new UploadWaypoints("upload " + list, list, List.of(waypoints)));
    }

    private void fly(String list, int from, Waypoint... waypoints) {
        assertThat(upload(list, waypoints)).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("start " + list, list, from))).isInstanceOf(Ack.class);
    }

    private void completes(String list) {
        Await.until(
                list + " is completed",
                () -> client.hasHeard(message -> message instanceof Progress progress
                        && progress.listId().equals(list)
                        && progress.completed()));
    }

    @Test
    void itTakesOffFliesAPathAndStaysAtItsEnd() {
        fly("path", 0, UP, NORTH, EAST);
        completes("path");

        assertThat(copter.metresTo(EAST.latDeg(), EAST.lonDeg())).isLessThan(2);
        assertThat(copter.heightM()).isBetween(29.0, 31.0);
        assertThat(copter.isArmed()).isTrue();
        assertThat(copter.armings()).isEqualTo(1);
        Await.until(
                "its altitude is reported",
                () -> client.last(Telemetry.class).orElseThrow().altM().orElse(0) > 29);
        Await.until(
                "it is said to keep its place",
                () -> client.last(Telemetry.class).orElseThrow().mode() == BoatMode.HOLD);
    }

    @Test
    void aPathToTheGroundEndsWithALandingAndMotorsOff() {
        fly("path", 0, UP, EAST, GROUND);
        completes("path");

        assertThat(copter.isArmed()).isFalse();
        assertThat(copter.heightM()).isZero();
        assertThat(copter.metresTo(GROUND.latDeg(), GROUND.lonDeg())).isLessThan(2);
        assertThat(copter.fell()).isFalse();
        assertThat(client.isObserver()).isFalse();
    }

    @Test
    void copterOverItsLandingPlaceLandsThere() {
        fly("path", 0, UP, NORTH);
        completes("path");

        fly("down", 0, NORTH, new Waypoint(NORTH.latDeg(), NORTH.lonDeg(), 8, 0));
        completes("down");

        assertThat(copter.isArmed()).isFalse();
        assertThat(copter.heightM()).isZero();
    }

    @Test
    void whoStartsItsMotorsAfterALandingIsSomebodyElse() {
        fly("path", 0, UP, GROUND);
        completes("path");

        copter.armedByPilot();

        client.untilAlarm("mav6 is taken by a pilot or another ground station (AUTO)");
    }

    @Test
    void pilotWhoTakesItAsItIsToKeepItsPlaceForANewPathHasIt() {
        fly("path", 0, UP, FAR);
        copter.takenByPilotAt(SET_MODE, SmallCopter.STABILIZE); // in place of BRAKE

        assertThat(upload("another", UP, EAST))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.NOT_COMMANDER));

        Await.until("it is noticed that it is taken", client::isObserver);
        assertThat(copter.mode()).isEqualTo(SmallCopter.STABILIZE);
    }

    @Test
    void whatLeadsOverTheGroundOnlyIsDoneThere() {
        fly("land", 0, new Waypoint(45.7, 10.72, 8, 0));
        completes("land");

        assertThat(copter.armings()).isZero();
    }

    @Test
    void itGoesOnAtTheWaypointThatIsAskedFor() {
        fly("path", 2, FAR, FAR, EAST);
        completes("path");

        assertThat(copter.metresTo(EAST.latDeg(), EAST.lonDeg())).isLessThan(2);
    }

    @Test
    void stopInTheAirKeepsItWhereItIsWithItsMotorsOn() {
        fly("path", 0, UP, FAR);
        Await.until("it is in the air", () -> copter.heightM() > 5);

        assertThat(client.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);

        assertThat(copter.mode()).isEqualTo(SmallCopter.BRAKE);
        assertThat(copter.isArmed()).isTrue();
        assertThat(copter.fell()).isFalse();
        fly("next", 0, UP, EAST);
        completes("next");
    }

    @Test
    void stopOnTheGroundTurnsItsMotorsOff() {
        copter.armedByPilot();

        assertThat(client.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);

        assertThat(copter.isArmed()).isFalse();
    }

    @Test
    void fleetStopHoldsUntilItIsReleased() {
        fly("path", 0, UP, FAR);
        Await.until("it is in the air", () -> copter.heightM() > 5);

        assertThat(client.ask(new FleetStop("all"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("again", "path", 1)))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.FLEET_STOPPED));
        assertThat(copter.mode()).isEqualTo(SmallCopter.BRAKE);
        Await.until(
                "it is said to be stopped",
                () -> client.last(Telemetry.class).orElseThrow().mode() == BoatMode.FLEET_STOP);

        assertThat(client.ask(new FleetRelease("go"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("now", "path", 1))).isInstanceOf(Ack.class);
        assertThat(copter.mode()).isEqualTo(SmallCopter.AUTO);
    }

    @Test
    void aLandingUnderWayIsRefused() {
        assertThat(upload("path", UP, GROUND, UP)).isInstanceOfSatisfying(Nack.class, nack -> {
            assertThat(nack.reason()).isEqualTo(NackReason.NOT_ABLE);
            assertThat(nack.detail()).contains("lands only at the end of a path, and waypoint 2 is on the ground");
        });
    }

    @Test
    void whatItHoldsIsReadBackWithItsAltitudes() {
        upload("path", UP, EAST, GROUND);

        assertThat(client.ask(new ReadBack("read")))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class,
                        held -> assertThat(held.waypoints()).containsExactly(UP, EAST, GROUND));
    }

    @Test
    void pilotWhoTakesItIsNamed() {
        fly("path", 0, UP, FAR);
        Await.until("it is in the air", () -> copter.heightM() > 5);

        copter.takenByPilot(SmallCopter.STABILIZE);

        client.untilAlarm("mav6 is taken by a pilot or another ground station (STABILIZE)");
        Await.until("the base only observes", client::isObserver);
    }

    @Test
    void itsLostLinkActionIsItsOneParameter() {
        assertThat(client.ask(new SetLostLinkAction("home", LostLinkAction.RETURN)))
                .isInstanceOf(Ack.class);
        assertThat(copter.parameter("FS_GCS_ENABLE")).isEqualTo(1);
        assertThat(client.ask(new SetLostLinkAction("stay", LostLinkAction.HOLD)))
                .isInstanceOf(Ack.class);
        assertThat(copter.parameter("FS_GCS_ENABLE")).isEqualTo(7);
        assertThat(client.last(SettingsReport.class).orElseThrow().lostLinkAction())
                .isEqualTo(LostLinkAction.HOLD);
    }

    @Test
    void whereItWasArmedIsItsHome() {
        fly("path", 0, UP, NORTH, EAST);
        completes("path");

        Waypoint home = client.last(SettingsReport.class).orElseThrow().home().orElseThrow();
        assertThat(home.latDeg()).isCloseTo(45.7, within(1e-6));
        assertThat(home.lonDeg()).isCloseTo(10.72, within(1e-6));
    }

    @Test
    void baseThatMeetsItInTheAirReadsItsHome() {
        fly("path", 0, new Waypoint(45.7002, 10.72, 8, 20), EAST);
        completes("path");
        client.close();
        client = new LinkClient(folder, copter.address() + "/6");

        Await.until(
                "its home is known",
                () -> client.last(SettingsReport.class)
                        .flatMap(SettingsReport::home)
                        .isPresent());
        Waypoint home = client.last(SettingsReport.class).orElseThrow().home().orElseThrow();
        assertThat(home.latDeg()).isCloseTo(45.7, within(1e-6));
        assertThat(home.lonDeg()).isCloseTo(10.72, within(1e-6));
    }

    @Test
    void sticksOfTheBaseDoNotFlyIt() {
        client.say(new Teleoperate(1, 0));

        client.untilAlarm("vehicle 6 is not flown by hand from here");
        assertThat(copter.armings()).isZero();
    }
}
