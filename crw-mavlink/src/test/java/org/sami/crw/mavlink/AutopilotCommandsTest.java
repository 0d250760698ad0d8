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
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;

/** Orders that a later one, the vehicle or another ground station prevents, and impossible reports, on a simulated vehicle. */
@Timeout(900)
class AutopilotCommandsTest {
    private static final int MANUAL = 0;
    private static final int CRITICAL = 2; // of MAV_SEVERITY
    private static final int WARNING = 4;
    private static final int NOTICE = 5;
    private static final int INFO = 6;
    private static final int HOLD = 4;
    private static final int LOITER = 5;
    private static final int AUTO = 10;
    private static final int GUIDED = 15;
    private static final List<Waypoint> LIST =
            List.of(new Waypoint(45.71, 10.72, 1), new Waypoint(45.71, 10.73, 1), new Waypoint(45.72, 10.73, 2));

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
        client = new LinkClient(folder, boat.address() + "/5");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    private static UploadWaypoints upload(String list) {
        return new UploadWaypoints("upload " + list, list, LIST);
    }

    private void drive() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("start", "first", 0))).isInstanceOf(Ack.class);
        assertThat(boat.mode()).isEqualTo(AUTO);
    }

    /** The vehicle does not say in which mode it is, and the gateway does not give that up meanwhile. */
    private void keepHeartbeats() {
        client.slow(true);
        boat.reports().beating(false);
    }

    private void sendHeartbeats() {
        boat.reports().beating(true);
        client.slow(false);
    }

    @Test
    void stopIsDoneAlthoughAnOrderBeforeItFailsLater() {
        StopMotors stop = new StopMotors("stop");
        client.say(upload("first"));
        client.say(new StartWaypoints("start", "first", 0));
        client.say(stop);
        client.say(upload("second"));

        assertThat(client.answerTo(stop)).isInstanceOf(Ack.class);
    }

    @Test
    void stopOrdersHoldEvenIfTheVehicleWasLastHeardInIt() {
        keepHeartbeats();
        boat.takenByPilot(AUTO, true);

        assertThat(client.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);

        assertThat(boat.isArmed()).isFalse();
        assertThat(boat.mode()).isEqualTo(HOLD);
    }

    @Test
    void missionIsNotReplacedUnderAVehicleThatDoesNotKeepItsPlace() {
        drive();
        boat.faults().refuseMode(LOITER);

        assertThat(client.ask(upload("second")))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.NOT_ABLE));

        assertThat(client.ask(new ReadBack("read")))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class, held -> assertThat(held.listId()).isEqualTo("first"));
        assertThat(boat.mission().uploads()).isEqualTo(1);
    }

    @Test
    void boatDoesNotSetOffAfterItsBaseHasLeft() {
        boat.faults().ignoresMissions(true);
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        client.say(new StartWaypoints("start", "first", 0));

        client.leave();
        boat.faults().ignoresMissions(false);

        Await.until("it has the list", () -> boat.mission().uploads() == 1);
        Await.holds("it lies still", 4, () -> !boat.isArmed());
    }

    @Test
    void refusedOrderLeavesInForceWhatWasOrderedBefore() {
        drive();
        boat.reports().loseEstimate();
        for (int i = 0; !(client.ask(new HoldPosition("hold " + i)) instanceof Nack); i++) {
            assertThat(boat.isArmed()).isTrue(); // until it is heard that the place is lost
        }

        boat.takenByPilot(MANUAL, true);

        Await.until("it is noticed that it is taken", client::isObserver);
    }

    @Test
    void whoTookItHasItStillOverANewConnection() {
        drive();
        boat.takenByPilot(MANUAL, true);
        Await.until("it is noticed that it is taken", client::isObserver);

        assertThat(client.reconnect()).isEqualTo(Role.OBSERVER);

        assertThat(boat.mode()).isEqualTo(MANUAL);
    }

    @Test
    void whoReplacesTheMissionUnderWayHasTakenIt() {
        drive();
        long before = client.count(Telemetry.class);
        Await.until("what it holds has been seen", () -> client.count(Telemetry.class) > before + 2);

        boat.mission().lose();

        Await.until("it is noticed that it is taken", client::isObserver);
        client.untilAlarm("mav5 is taken by a pilot or another ground station (AUTO)");
        assertThat(client.ask(new TakeCommand("take", "client.0", 2))).isInstanceOf(Ack.class);
    }

    /** As many items as the base has given it, all of them elsewhere. */
    private List<MissionItem> equalCount(double latDeg) {
        int items = LIST.size() + 4; // home, two speeds, the waypoints, and the item that keeps the place
        return IntStream.range(0, items)
                .mapToObj(i -> MissionItem.waypoint(i, latDeg, 10.72 + i * 1e-6, 0, 0))
                .toList();
    }

    private void isTakenWithoutProgress() {
        Await.until("it is noticed that it is taken", client::isObserver);
        client.untilAlarm("mav5 is taken by a pilot or another ground station (AUTO)");
        reports();
        assertThat(client.last(Progress.class).map(Progress::nextIndex)).contains(0);
        client.takeCommand();
        assertThat(client.ask(new StartWaypoints("start again", "first", 0))).isInstanceOf(Ack.class);
        assertThat(boat.mission().uploads()).isEqualTo(2);
    }

    @Test
    void missionOfAsManyItemsThatTheVehicleSaysToHaveIsNoticedByReadingItBack() {
        drive();

        boat.replaceMission(equalCount(45.8)); // out of reach

        isTakenWithoutProgress();
        assertThat(client.alarms("it holds another mission than it was given")).hasSize(1);
        assertThat(client.alarms("is taken by")).hasSize(1);
        assertThat(client.alarms("mission changed")).hasSize(1);
    }

    @Test
    void missionOfAsManyItemsOfWhichTheVehicleSaysNothingIsNoticedAtItsFirstWaypoint() {
        drive();

        boat.mission().put(equalCount(45.69999));

        isTakenWithoutProgress();
        client.untilAlarm("it says that it has reached waypoint 1, and is ");
    }

    @Test
    void waypointThatSomebodyElseHasItLeaveOutIsNoProgress() {
        drive();
        boat.mission().setCurrent(LIST.size() + 2); // behind home and two speeds: the last waypoint

        client.untilAlarm("it has left out waypoint 1");
        Await.until("it is noticed that it is taken", client::isObserver);
        assertThat(client.last(Progress.class).map(Progress::nextIndex)).contains(0);
        client.takeCommand();
        assertThat(client.ask(new StartWaypoints("start again", "first", 0))).isInstanceOf(Ack.class);
        assertThat(boat.mission().uploads()).isEqualTo(1);
    }

    @Test
    void ownMissionOfWhichTheVehicleSaysThatItChangedStaysItsOwn() {
        drive();

        boat.says(CRITICAL, "Auto mission changed, restarted command");

        client.untilAlarm("Auto mission changed");
        assertThat(client.ask(new ReadBack("read"))) // after the reading that the text has begun
                .isInstanceOfSatisfying(
                        HeldWaypoints.class, held -> assertThat(held.listId()).isEqualTo("first"));
        assertThat(client.isObserver()).isFalse();
    }

    @Test
    void whatItSaysIsAMessageOfItsWeightAndOneHoweverOftenItIsRepeated() {
        boat.says(INFO, "Mission: 1 WP");
        boat.says(WARNING, "EKF3 lane switch 1");
        boat.says(WARNING, "EKF3 lane switch 1");
        boat.says(NOTICE, "Throttle armed");

        client.untilAlarm("Throttle armed");

        assertThat(client.said("mav5 says: ", Priority.LOW))
                .containsExactly("mav5 says: Mission: 1 WP", "mav5 says: Throttle armed");
        assertThat(client.said("mav5 says: ", Priority.HIGH)).containsExactly("mav5 says: EKF3 lane switch 1");
    }

    @Test
    void speedThatCannotBeDoesNotEndItsOtherReports() {
        boat.reports().claimSpeed(200);
        boat.reports().charge(10);

        Await.until(
                "its charge is reported",
                () -> client.hasHeard(message -> message instanceof BatteryReport battery && battery.percent() == 10));
    }

    @Test
    void missionThatSomebodyElseReplacedIsSentAgainBeforeItIsFollowed() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read"))).isInstanceOf(HeldWaypoints.class);
        assertThat(client.ask(new ReadBack("read again"))).isInstanceOf(HeldWaypoints.class);
        assertThat(boat.mission().uploads()).isEqualTo(1);

        boat.mission().lose();

        assertThat(client.ask(new StartWaypoints("start", "first", 0))).isInstanceOf(Ack.class);
        assertThat(boat.mission().uploads()).isEqualTo(2);
    }

    @Test
    void missionOfAPilotWhoHasTheCommandIsNoProgress() {
        drive();
        boat.takenByPilot(MANUAL, true);
        Await.until("it is noticed that it is taken", client::isObserver);
        boat.mission()
                .put(IntStream.range(0, 9)
                        .mapToObj(i -> MissionItem.waypoint(i, 45.7, 10.72, 0, 0))
                        .toList());
        reports();

        boat.takenByPilot(AUTO, true);

        Await.until(
                "it follows the pilot's mission", () -> boat.mission().visited().size() == 8);
        reports();
        assertThat(client.last(Progress.class).map(Progress::nextIndex)).contains(0);
        client.takeCommand();
        assertThat(client.ask(new StartWaypoints("start again", "first", 0))).isInstanceOf(Ack.class);
        assertThat(boat.mission().uploads()).isEqualTo(2);
    }

    private void reports() {
        long before = client.count(Telemetry.class);
        Await.until("it has reported itself", () -> client.count(Telemetry.class) > before + 2);
    }

    @Test
    void listThatComesRightAfterAStopDoesNotUndoIt() {
        drive();
        keepHeartbeats();
        StopMotors stop = new StopMotors("stop");
        UploadWaypoints second = upload("second");
        client.say(stop);
        client.say(second);
        Await.until("it is stopped", () -> boat.mode() == HOLD);
        sendHeartbeats();

        assertThat(client.answerTo(stop)).isInstanceOf(Ack.class);
        assertThat(client.answerTo(second)).isInstanceOf(Ack.class);

        assertThat(boat.isArmed()).isFalse();
        assertThat(boat.orderedModes()).doesNotContain(LOITER);
    }

    @Test
    void baseThatLeavesRightAfterAStopDoesNotUndoIt() {
        drive();
        keepHeartbeats();
        client.say(new StopMotors("stop"));
        Await.until("it is disarmed", () -> !boat.isArmed());

        client.reconnect();
        sendHeartbeats();

        Await.until("it is stopped", () -> boat.mode() == HOLD);
        assertThat(boat.isArmed()).isFalse();
        assertThat(boat.orderedModes()).doesNotContain(LOITER);
    }

    @Test
    void waypointThatIsReachedBeforeTheStartIsAnsweredStaysReached() {
        List<Waypoint> near = List.of(new Waypoint(45.70002, 10.72, 1), new Waypoint(45.71, 10.72, 1));
        assertThat(client.ask(new UploadWaypoints("upload", "near", near))).isInstanceOf(Ack.class);
        boat.faults().ignoresSpeeds(true);
        StartWaypoints start = new StartWaypoints("start", "near", 0);
        client.say(start);
        Await.until(
                "the first is reached",
                () -> client.last(Progress.class)
                        .filter(progress -> progress.nextIndex() == 1)
                        .isPresent());

        boat.faults().ignoresSpeeds(false);

        assertThat(client.answerTo(start)).isInstanceOf(Ack.class);
        assertThat(client.last(Progress.class).map(Progress::nextIndex)).contains(1);
    }

    @Test
    void vehicleThatDisarmsItselfAtTheStartIsNamedSo() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        boat.faults().disarmsItself();

        assertThat(client.ask(new StartWaypoints("start", "first", 0)))
                .isInstanceOfSatisfying(
                        Nack.class,
                        nack -> assertThat(nack.detail())
                                .isEqualTo("vehicle 5 accepts, but does not come into mode AUTO, armed:"
                                        + " it is in mode AUTO, disarmed"));
    }

    @Test
    void whoDrivesItByHandKeepsItFromABaseThatComes() {
        client.close();
        boat.takenByPilot(MANUAL, true);

        client = new LinkClient(folder, boat.address() + "/5");

        assertThat(client.isObserver()).isTrue();
        client.untilAlarm("mav5 is taken by a pilot or another ground station (MANUAL): its missions wait until you");
        client.takeCommand();
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
    }

    @Test
    void stopIsAskedForUntilTheVehicleAnswers() {
        drive();
        boat.faults().ignoresOrders(true);
        StopMotors stop = new StopMotors("stop");
        client.say(stop);
        Await.until(
                "it was asked longer than other orders are", () -> boat.faults().ignoredOrders() > 6);
        client.say(stop); // as a base does while there is no answer

        boat.faults().ignoresOrders(false);

        assertThat(client.answerTo(stop)).isInstanceOf(Ack.class);
        assertThat(boat.isArmed()).isFalse();
        assertThat(boat.mode()).isEqualTo(HOLD);
    }

    private void failsToSetOff() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        boat.faults().refuseMode(AUTO);
        assertThat(client.ask(new StartWaypoints("start", "first", 0)))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.detail()).doesNotContain("armed"));
    }

    @Test
    void vehicleThatAnOrderArmedBeforeItFailedIsDisarmed() {
        failsToSetOff();

        assertThat(boat.isArmed()).isFalse();
    }

    @Test
    void orderAfterOneThatFailedArmsItAnew() {
        failsToSetOff();

        assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class);

        assertThat(boat.isArmed()).isTrue();
        assertThat(boat.mode()).isEqualTo(LOITER);
    }

    @Test
    void vehicleThatWasDisarmedOnItsWayIsArmedLyingStill() {
        drive();
        boat.takenByPilot(AUTO, false);
        Await.until("it is noticed that it is taken", client::isObserver);
        client.takeCommand();
        assertThat(client.ask(new UploadWaypoints("upload one", "one", LIST.subList(0, 1))))
                .isInstanceOf(Ack.class);
        boat.faults().refuseMode(GUIDED);

        assertThat(client.ask(new StartWaypoints("go", "one", 0))).isInstanceOf(Nack.class);

        assertThat(boat.orderedModes()).containsExactly(AUTO, HOLD, GUIDED);
        assertThat(boat.mode()).isEqualTo(HOLD);
        assertThat(boat.isArmed()).isFalse();
    }

    @Test
    void pathThatEndsWhereItLiesIsNotTakenForDrivenBeforeItIsStarted() {
        Waypoint near = new Waypoint(45.70001, 10.72, 1);
        assertThat(client.ask(new UploadWaypoints("upload near", "near", List.of(near))))
                .isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("go", "near", 0))).isInstanceOf(Ack.class);
        Await.until("it is there", () -> isCompleted("near"));

        assertThat(client.ask(new UploadWaypoints("upload loop", "loop", List.of(LIST.get(0), near))))
                .isInstanceOf(Ack.class);

        long before = client.count(Telemetry.class);
        Await.until("it has said where it is", () -> client.count(Telemetry.class) > before + 2);
        assertThat(isCompleted("loop")).isFalse();
        assertThat(boat.mode()).as("it keeps its place").isEqualTo(LOITER);
    }

    private boolean isCompleted(String list) {
        return client.hasHeard(message ->
                message instanceof Progress progress && progress.listId().equals(list) && progress.completed());
    }
}
