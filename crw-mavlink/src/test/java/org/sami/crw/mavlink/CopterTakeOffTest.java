package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.mavlink.testing.TcpRelay;

/** A copter on the ground, or too low, that is to go on in the midst of a path, on a simulated one that takes off in GUIDED as ArduPilot's copters do. */
@Tag("long")
@Timeout(900)
class CopterTakeOffTest {
    private static final double WAIT_S = 300; // a machine that does much else flies slowly
    private static final int SYSTEM = 6;
    private static final int GO_TO_A_PLACE = 192;
    private static final int GO_ON_AT = 224;
    private static final int FROM = 650; // the part of the path from there on has no take-off
    private static final int IN_THE_FIRST_PART =
            400; // so far along it that the next part takes the place of the take-off
    private static final double HEIGHT_M = 20;
    private static final int LOCATIONS = 700;

    /** More than an autopilot has room for. */
    private static final List<Waypoint> LONG = IntStream.range(0, LOCATIONS)
            .mapToObj(i -> new Waypoint(45.7 + i * 2e-5, 10.72, 8, HEIGHT_M))
            .toList();

    private static final double LAT = LONG.get(FROM).latDeg();
    private static final double LON = 10.7203; // 23 m beside the path

    @TempDir
    private Path folder;

    private SmallCopter copter;
    private TcpRelay relay;
    private LinkClient client;

    @BeforeEach
    void place() throws Exception {
        place(10);
    }

    private void place(double times) throws Exception {
        copter = new SmallCopter(SYSTEM, LAT, LON, times);
        relay = new TcpRelay(port(copter.address()));
        client = base();
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        relay.close();
        copter.close();
    }

    private static int port(String address) {
        return Integer.parseInt(address.substring(address.lastIndexOf(':') + 1));
    }

    private LinkClient base() {
        return new LinkClient(folder, relay.address() + "/" + SYSTEM);
    }

    private LinkMessage start(String name, int from) {
        return client.ask(new StartWaypoints(name, "path", from));
    }

    private void upload(List<Waypoint> path) {
        assertThat(client.ask(new UploadWaypoints("upload", "path", path))).isInstanceOf(Ack.class);
        reads("read", path);
    }

    private void reads(String name, List<Waypoint> path) {
        assertThat(client.ask(new ReadBack(name)))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class,
                        held -> assertThat(held.waypoints()).isEqualTo(path));
    }

    private void takesOff() {
        takesOff(FROM);
    }

    private void takesOff(int from) {
        upload(LONG);
        assertThat(start("start", from)).isInstanceOf(Ack.class);
        assertThat(copter.takeOffs()).isEqualTo(1);
        assertThat(copter.heightM()).isBetween(CopterMotion.GROUND_M, HEIGHT_M);
    }

    private void completes() {
        Await.until(
                "it is at the end of its path",
                WAIT_S,
                () -> client.last(Progress.class).filter(Progress::completed).isPresent());
    }

    private void fliesTheRest() {
        fliesTheRest(FROM);
    }

    private void fliesTheRest(int from) {
        completes();
        assertThat(copter.mission().visited())
                .isEqualTo(LONG.subList(from, LOCATIONS).stream()
                        .map(place -> List.of(degrees(place.latDeg()), degrees(place.lonDeg())))
                        .toList());
        assertThat(copter.nearestM(
                        LONG.get(from - 10).latDeg(), LONG.get(from - 10).lonDeg()))
                .as("metres from an earlier place")
                .isGreaterThan(15);
        assertThat(copter.takeOffs()).isEqualTo(1);
        assertThat(copter.armings()).isEqualTo(1);
        assertThat(copter.fell()).isFalse();
    }

    private static double degrees(double exact) {
        return Math.round(exact * 1e7) / 1e7;
    }

    @Test
    void goesOnFromTheGroundInTheMidstOfAPathThatItHoldsInParts() {
        takesOff();

        fliesTheRest();
        assertThat(copter.mode()).isEqualTo(SmallCopter.AUTO);
    }

    @Test
    void nextPartThatTakesThePlaceOfTheTakeOffDuringTheClimbDoesNotDisturbIt() {
        takesOff(IN_THE_FIRST_PART);

        fliesTheRest(IN_THE_FIRST_PART);
    }

    @Test
    void climbsStraightUpToTheHeightOfWhereItGoes() throws Exception {
        end();
        place(1);
        Waypoint high = new Waypoint(45.71, 10.72, 8, 14);
        upload(List.of(new Waypoint(45.7, 10.72, 8, 10), high));

        assertThat(start("start", 1)).isInstanceOf(Ack.class);

        Await.until("it is nearly up", () -> copter.heightM() > 12.5);
        assertThat(copter.metresTo(LAT, LON)).isLessThan(1);
        Await.until("it flies", () -> copter.mode() == SmallCopter.AUTO);
        assertThat(copter.heightM()).isGreaterThan(12.5);
        assertThat(copter.mission().visited()).isEmpty();
    }

    /** As where its link was lost and is back: its path rises from the low point to the next. */
    @Test
    void copterThatFliesToAHighPointAlreadyIsNotMadeToClimbBeforeIt() throws Exception {
        end();
        place(1);
        Waypoint low = new Waypoint(LAT, LON, 8, 5);
        Waypoint high = new Waypoint(LAT + 0.01, LON, 8, HEIGHT_M);
        upload(List.of(new Waypoint(LAT + 1e-5, LON, 8, HEIGHT_M), low, high));
        assertThat(start("start", 0)).isInstanceOf(Ack.class);
        Await.until(
                "it is on its way to the last point",
                WAIT_S,
                () -> client.last(Progress.class)
                        .filter(progress -> progress.nextIndex() == 2)
                        .isPresent());
        Await.until("it has said so, too", WAIT_S, () -> copter.metresTo(LAT, LON) > 20);
        assertThat(copter.heightM()).isLessThan(HEIGHT_M - 2);

        assertThat(start("again", 2)).isInstanceOf(Ack.class);

        assertThat(copter.mode()).isEqualTo(SmallCopter.AUTO);
        assertThat(copter.takeOffs()).isZero();
    }

    @Test
    void stopDuringTheClimbLeavesItBrakedInTheAirAndItClimbsOnFromThere() throws Exception {
        end();
        place(1);
        takesOff();

        assertThat(client.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);

        assertThat(copter.mode()).isEqualTo(SmallCopter.BRAKE);
        assertThat(copter.isArmed()).isTrue();
        double stoppedM = copter.heightM();
        assertThat(stoppedM).isLessThan(HEIGHT_M / 2);
        Await.holds(
                "it stays there",
                3,
                () -> copter.mode() == SmallCopter.BRAKE && Math.abs(copter.heightM() - stoppedM) < 0.1);

        assertThat(start("again", FROM)).isInstanceOf(Ack.class);
        Await.until("it flies", () -> copter.mode() == SmallCopter.AUTO);
        assertThat(copter.heightM()).isGreaterThan(HEIGHT_M - 1.5);
        assertThat(copter.metresTo(LAT, LON)).isLessThan(8); // a heartbeat's way
        assertThat(copter.takeOffs()).isEqualTo(1);
        assertThat(copter.fell()).isFalse();
    }

    @Test
    void fleetStopDuringTheClimbHolds() throws Exception {
        end();
        place(1);
        takesOff();

        assertThat(client.ask(new FleetStop("all"))).isInstanceOf(Ack.class);

        Await.until(
                "it is said", () -> client.last(Telemetry.class).orElseThrow().mode() == BoatMode.FLEET_STOP);
        Await.holds("it stays", 3, () -> copter.mode() == SmallCopter.BRAKE && copter.isArmed());
    }

    @Test
    void anotherListDuringTheClimbReplacesWhatItWasToGoOnWith() throws Exception {
        end();
        place(2);
        takesOff();

        assertThat(client.ask(new UploadWaypoints("other", "other", LONG.subList(0, 3))))
                .isInstanceOf(Ack.class);

        Await.holds("it stays", 5, () -> copter.mode() == SmallCopter.BRAKE && copter.isArmed());
    }

    @Test
    void baseThatIsKilledDuringTheClimbLeavesItAboveAndTheNextOneDoesNotHaveItTakeOffAgain() throws Exception {
        end();
        place(2);
        takesOff();
        relay.cut(true); // nothing that the base does at its end comes through
        client.close();

        relay.close();
        relay = new TcpRelay(port(copter.address()));
        client = base();
        Await.until("it is up", () -> copter.heightM() > HEIGHT_M - 0.5);
        Await.holds(
                "it waits there",
                3,
                () -> copter.mode() == SmallCopter.GUIDED
                        && copter.heightM() < HEIGHT_M + 1
                        && copter.metresTo(LAT, LON) < 1);

        reads("read again", LONG);
        assertThat(client.last(Progress.class).orElseThrow().nextIndex()).isEqualTo(FROM);
        assertThat(start("again", FROM)).isInstanceOf(Ack.class);
        fliesTheRest();
    }

    @Test
    void nextBaseThatComesWhileItIsLowHasItClimbOn() throws Exception {
        end();
        place(0.5);
        takesOff();
        relay.cut(true);
        client.close();
        relay.close();
        relay = new TcpRelay(port(copter.address()));
        client = base();

        reads("read again", LONG);
        assertThat(start("again", FROM)).isInstanceOf(Ack.class);

        assertThat(copter.heightM()).isLessThan(HEIGHT_M - 2);
        Await.until("it flies", () -> copter.mode() == SmallCopter.AUTO);
        assertThat(copter.heightM()).isGreaterThan(HEIGHT_M - 1.5);
        assertThat(copter.takeOffs()).isEqualTo(1);
    }

    @Test
    void linkThatIsLostDuringTheClimbForAMomentDoesNotEndIt() throws Exception {
        end();
        place(2);
        takesOff();
        relay.cut(true);
        Await.until("it is up", () -> copter.heightM() > HEIGHT_M - 0.5);
        Await.holds("it waits there", 3, () -> copter.mode() == SmallCopter.GUIDED);

        relay.cut(false);

        fliesTheRest();
    }

    @Test
    void baseThatLeavesItUnheardDuringTheClimbHasItWaitAboveUntilItIsSentOn() throws Exception {
        end();
        place(2);
        takesOff();
        relay.cut(true);
        Await.until("it is up", () -> copter.heightM() > HEIGHT_M - 0.5);
        Await.holds("it is silent", 3, () -> copter.mode() == SmallCopter.GUIDED);
        client.leave();

        relay.cut(false);
        Await.holds("it waits there", 6, () -> copter.mode() == SmallCopter.GUIDED);

        client.reconnect();
        assertThat(start("again", FROM)).isInstanceOf(Ack.class);
        fliesTheRest();
    }

    @Test
    void missionThatSomebodyElsePutsThereDuringTheClimbIsNotFlown() throws Exception {
        end();
        place(5);
        upload(LONG);
        int items = copter.mission().size();
        assertThat(start("start", FROM)).isInstanceOf(Ack.class);

        copter.mission()
                .put(IntStream.range(0, items)
                        .mapToObj(i -> MissionItem.waypoint(i, 45.69, 10.72 + i * 1e-5, HEIGHT_M, 0))
                        .toList());

        fliesTheRest();
    }

    @Test
    void pilotWhoTakesItDuringTheClimbHasIt() throws Exception {
        end();
        place(2);
        takesOff();

        copter.takenByPilot(SmallCopter.STABILIZE);

        client.untilAlarm("mav6 is taken by a pilot or another ground station (STABILIZE)");
        Await.until("the base only observes", client::isObserver);
        Await.holds("it stays the pilot's", 5, () -> copter.mode() == SmallCopter.STABILIZE);
    }

    /** What is not answered is sent again, also where it orders the climb of one that was stopped too low. */
    @Test
    void pilotWhoTakesItAsItIsOrderedToClimbOnHasIt() throws Exception {
        end();
        place(1);
        takesOff();
        assertThat(client.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);
        copter.takenByPilotAt(GO_TO_A_PLACE, SmallCopter.STABILIZE);

        assertThat(start("again", FROM))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.NOT_COMMANDER));

        assertThat(copter.mode()).isEqualTo(SmallCopter.STABILIZE);
    }

    @Test
    void pilotWhoTakesItAsItIsToGoOnAfterTheClimbHasIt() throws Exception {
        end();
        place(5);
        takesOff();
        copter.takenByPilotAt(GO_ON_AT, SmallCopter.STABILIZE);

        client.untilAlarm("mav6 is taken by a pilot or another ground station (STABILIZE)");
        Await.holds("it stays the pilot's", 3, () -> copter.mode() == SmallCopter.STABILIZE);
    }

    @Test
    void climbThatEndsTooLowIsAnAlarmAndItStaysThere() {
        copter.ceiling(12);
        takesOff();

        client.untilAlarm("vehicle 6 has taken off, and does not go on along its path: it is to climb to 20 m, and has"
                + " come no higher than 12.0 m for 15 s");
        Await.until("it stays there", () -> copter.mode() == SmallCopter.BRAKE);
        assertThat(copter.isArmed()).isTrue();
        assertThat(copter.metresTo(LAT, LON)).isLessThan(1);
    }

    @Test
    void copterThatRefusesToTakeOffIsDisarmed() {
        upload(LONG);
        copter.refuseTakeOffs();

        assertThat(start("start", FROM))
                .isInstanceOfSatisfying(
                        Nack.class,
                        nack -> assertThat(nack.detail())
                                .startsWith("vehicle 6 fails to take off to 20 m over its home"));
        assertThat(copter.isArmed()).isFalse();
    }

    @Test
    void copterThatDoesNotLiftOffIsDisarmed() {
        upload(LONG);
        copter.ceiling(0.05);

        assertThat(start("start", FROM))
                .isInstanceOfSatisfying(
                        Nack.class,
                        nack -> assertThat(nack.detail()).startsWith("vehicle 6 accepts, but does not take off"));
        Await.until("its motors are off", () -> !copter.isArmed());
    }

    @Test
    void answerThatIsLostDoesNotHaveItTakeOffTwice() {
        copter.loseAnswersToTakeOffs();
        takesOff();

        fliesTheRest();
    }
}
