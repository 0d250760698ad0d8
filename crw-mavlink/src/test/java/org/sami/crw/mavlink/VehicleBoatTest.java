package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.mavlink.testing.SensorMessages;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

/** A vehicle that speaks MAVLink is a boat of a base like any other. */
@Tag("long")
@Timeout(900)
class VehicleBoatTest {
    private static final int MANUAL = 0;
    private static final int HOLD = 4;
    private static final int LOITER = 5;
    private static final int AUTO = 10;
    private static final int RTL = 11;
    private static final int GUIDED = 15;
    private static final double NEAR_M = 3;
    private static final long BEHIND_MS = 7_000;
    private static final GeoPoint START = GeoPoint.of(45.7, 10.72);
    private static final GeoPoint FIRST = GeoPoint.of(45.7003, 10.72);
    private static final GeoPoint SECOND = GeoPoint.of(45.7003, 10.7204);
    private static final GeoPoint THIRD = GeoPoint.of(45.7, 10.7204);
    private static final String BOAT = "mav7";

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private GatewayWorld world;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(7, START.latDeg(), START.lonDeg(), 20);
        world = new GatewayWorld(folder);
        world.connect(boat.address());
        world.untilReady(BOAT);
    }

    @AfterEach
    void end() throws Exception {
        world.close();
        boat.close();
        assertThat(world.faults).isEmpty();
    }

    private static FollowPath path(GeoPoint... points) {
        return FollowPath.of("p" + points.length, 1, 1, List.of(points), Priority.MEDIUM);
    }

    private void submit(FollowPath path) {
        world.tell(BOAT, proxy -> proxy.commands().submit(path));
    }

    private static boolean isUnderWay(BoatProxy proxy) {
        return proxy.status().mode().equals(Optional.of(BoatMode.PATH));
    }

    private double metresTo(GeoPoint point) {
        return boat.metresTo(point.latDeg(), point.lonDeg());
    }

    private void completes(String command) {
        Await.until(
                command + " is completed",
                GatewayWorld.WAIT_S,
                () -> world.has(
                        FleetEvent.CommandCompleted.class,
                        done -> done.command().commandId().equals(command)));
    }

    @Test
    void addressWithoutANumberBringsTheVehicleThatIsHeardThere() {
        assertThat(world.links()).singleElement().satisfies(link -> {
            assertThat(link.boatId()).contains(BOAT);
            assertThat(link.address()).isEqualTo(GatewayWorld.address(boat.address() + "/7"));
        });
        assertThat(boat.isArmed()).isFalse();
        assertThat(world.is(
                        BOAT, proxy -> proxy.status().battery().orElseThrow().percent() == 87))
                .isTrue();
    }

    @Test
    void saysItsSpeedAndItsTurnsByItsParametersAndWhatItCannotDo() {
        BoatPerformance performance =
                new BoatPerformance(OptionalDouble.empty(), OptionalDouble.of(1.5), OptionalDouble.of(2));

        assertThat(world.is(BOAT, proxy -> proxy.performance().equals(performance)))
                .isTrue();
        assertThat(world.is(
                        BOAT,
                        proxy -> proxy.capabilities().cannot().containsKey(BoatCapabilities.PANORAMA)
                                && proxy.capabilities().measures().isEmpty()))
                .isTrue();
    }

    @Test
    void measuresWhatItHasReported() {
        boat.sends(SensorMessages.named("TEMP", 12.5));
        world.until(
                "its thermometer is known",
                BOAT,
                proxy -> proxy.capabilities().measures().equals(Optional.of(List.of("autopilot/temp"))));

        boat.sends(SensorMessages.range(3.2));
        world.until(
                "its depth sounder is known, too",
                BOAT,
                proxy -> proxy.capabilities()
                        .measures()
                        .equals(Optional.of(List.of("autopilot/range", "autopilot/temp"))));

        assertThat(world.is(
                        BOAT,
                        proxy -> BoatDemands.missing(
                                        BOAT,
                                        proxy.capabilities(),
                                        "TakeMeasurement",
                                        Map.of("sensor", new TextValue("salinity")))
                                .isPresent()))
                .isTrue();
    }

    @Test
    void followsAPathAsOneMissionAndKeepsItsPlaceAtTheEnd() {
        submit(path(FIRST, SECOND, THIRD));

        completes("p3");

        assertThat(boat.mission().uploads()).isEqualTo(1);
        assertThat(boat.armings()).isEqualTo(1);
        assertThat(boat.mode()).isEqualTo(AUTO);
        assertThat(metresTo(THIRD)).isLessThan(NEAR_M);
        assertThat(world.has(FleetEvent.Progressed.class, news -> news.visited() == 1))
                .isTrue();
        world.until("it keeps its place", BOAT, proxy -> proxy.status().mode().equals(Optional.of(BoatMode.HOLD)));
    }

    @Test
    void followsAnotherPathFromTheEndOfTheFirst() {
        submit(path(FIRST, SECOND, THIRD));
        completes("p3");

        submit(path(SECOND, FIRST));

        completes("p2");
        assertThat(boat.mission().uploads()).isEqualTo(2);
        assertThat(metresTo(FIRST)).isLessThan(NEAR_M);
    }

    @Test
    void goesToASinglePlaceInGuidedWithoutAMission() {
        submit(path(FIRST));

        completes("p1");

        assertThat(boat.mission().uploads()).isZero();
        assertThat(boat.mode()).isEqualTo(GUIDED);
        assertThat(metresTo(FIRST)).isLessThan(NEAR_M);
    }

    @Test
    void stopsByBeingDisarmedAndStaysSoUntilItIsReleased() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        world.tell(BOAT, BoatProxy::fleetStop);

        world.until("it is stopped", BOAT, proxy -> proxy.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));
        assertThat(boat.isArmed()).isFalse();
        assertThat(boat.mode()).isEqualTo(HOLD);
        world.tell(BOAT, BoatProxy::fleetRelease);
        completes("p3");
    }

    @Test
    void whoTakesItIsNoticedAndItsMissionsWaitUntilItIsTakenBack() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        boat.takenByPilot(MANUAL, true);

        world.until("it is somebody else's", BOAT, proxy -> !proxy.isCommanding());
        assertThat(world.alarms)
                .contains(BOAT
                        + " is taken by a pilot or another ground station (MANUAL): its missions wait until"
                        + " you take it back");
        assertThat(boat.mode()).isEqualTo(MANUAL);
        world.tell(BOAT, proxy -> proxy.handOver().takeCommand());
        completes("p3");
        assertThat(boat.mission().uploads()).isEqualTo(1);
    }

    @Test
    void missionOfAVehicleThatIsTakenAsItIsSentWaitsUntilItIsTakenBack() {
        boat.faults().ignoresMissions(true);
        submit(path(FIRST, SECOND, THIRD));

        boat.takenByPilot(MANUAL, true);

        world.until("it is somebody else's", BOAT, proxy -> !proxy.isCommanding());
        boat.faults().ignoresMissions(false);
        world.tell(BOAT, proxy -> proxy.handOver().takeCommand());
        completes("p3");
    }

    private boolean hasCritical(String text) {
        return world.said.stream()
                .anyMatch(alarm ->
                        alarm.priority() == Priority.CRITICAL && alarm.text().startsWith(text));
    }

    @Test
    void whoArmsItDuringAFleetStopIsNamedAtOnceAndItIsNeverSaidNotToMove() {
        world.tell(BOAT, BoatProxy::fleetStop);
        world.until("it is stopped", BOAT, proxy -> proxy.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));
        boat.takenByPilot(MANUAL, false);
        world.until("it is somebody else's", BOAT, proxy -> !proxy.isCommanding());
        assertThat(world.said).noneMatch(alarm -> alarm.priority() == Priority.CRITICAL);

        boat.takenByPilot(MANUAL, true);
        boat.reports().claimSpeed(6.6);

        String who = "a pilot or another ground station (MANUAL)";
        Await.until(
                "it is told",
                GatewayWorld.WAIT_S,
                () -> hasCritical(BOAT + " is armed by " + who + " though it was stopped: it may move"));
        Await.until(
                "that it moves, too",
                GatewayWorld.WAIT_S,
                () -> hasCritical(BOAT + " moves at 6.6 m/s, armed by " + who));
        world.until("its state names them", BOAT, proxy -> proxy.stop().equals(StopLatch.overridden(who)));
        world.until(
                "it is said to move",
                BOAT,
                proxy -> proxy.explain().text().equals(BOAT + " moves at 6.6 m/s: " + who + " commands the boat"));

        world.tell(BOAT, BoatProxy::fleetStop);

        world.until("it is stopped again", BOAT, proxy -> proxy.stop().equals(StopLatch.HERE));
        assertThat(boat.isArmed()).isFalse();
    }

    @Test
    void whoArmsItInTheModeInWhichItWasStoppedIsNamedToo() {
        world.tell(BOAT, BoatProxy::fleetStop);
        world.until("it is stopped", BOAT, proxy -> proxy.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));

        boat.takenByPilot(HOLD, true);

        Await.until(
                "it is told",
                GatewayWorld.WAIT_S,
                () -> hasCritical(
                        BOAT + " is armed by a pilot or another ground station (HOLD) though it was stopped"));
    }

    @Test
    void failsafeOfItsOwnTakesItToo() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        boat.failsafe("GCS Failsafe", RTL);

        world.until("it acts by itself", BOAT, proxy -> !proxy.isCommanding());
        assertThat(world.alarms).contains(BOAT + " says: GCS Failsafe", ownFailsafe("GCS Failsafe", "RTL"));
    }

    private static String ownFailsafe(String words, String mode) {
        return BOAT + " is taken by its own failsafe \"" + words + "\" (" + mode
                + "): its missions wait until you take it back";
    }

    @Test
    void batteryFailsafeAsTheFirmwareReportsItTakesItAndIsACriticalBattery() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        boat.batteryFailsafe(RTL);

        world.until("it acts by itself", BOAT, proxy -> !proxy.isCommanding());
        assertThat(world.alarms).contains(ownFailsafe("Battery 1 is low 10.94V used 12 mAh", "RTL"));
        world.until(
                "its battery is critical",
                BOAT,
                proxy -> proxy.status().battery().orElseThrow().level() == BatteryLevel.CRITICAL);
    }

    @Test
    void crashThatItFindsIsItsOwnDoing() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        boat.crash();

        world.until("it acts by itself", BOAT, proxy -> !proxy.isCommanding());
        assertThat(world.alarms).contains(ownFailsafe("Crash: Going to HOLD", "HOLD"));
    }

    @Test
    void whoDrivesItByHandAfterItsFailsafeIsAPilot() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        boat.batteryFailsafe(MANUAL);

        world.until("it is taken", BOAT, proxy -> !proxy.isCommanding());
        assertThat(world.alarms)
                .contains(BOAT + " is taken by a pilot or another ground station (MANUAL): its missions wait until you"
                        + " take it back");
    }

    /** Its command fails for a reason that contains these words, and it is not armed. */
    private void assertFailsUnarmed(String words) {
        Await.until(
                "the command fails",
                GatewayWorld.WAIT_S,
                () -> world.has(
                        FleetEvent.CommandFailed.class,
                        failed -> failed.reason().contains(words)));
        assertThat(boat.isArmed()).isFalse();
    }

    @Test
    void refusalsAreInTheAutopilotsWords() {
        boat.faults().refuseArming("PreArm: GPS 1: Bad fix");

        submit(path(FIRST));

        assertFailsUnarmed("vehicle 7 fails to arm: PreArm: GPS 1: Bad fix");
    }

    @Test
    void firmwareWithoutACommandIsNamedWithWhatToDo() {
        boat.faults().lacksCommand(176); // DO_SET_MODE

        submit(path(FIRST));

        assertFailsUnarmed("(its firmware lacks this command: update it)");
    }

    @Test
    void afterARestartOfItsAutopilotItDoesNotMoveBeforeThatIsAllowed() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        boat.restart();

        Await.until(
                "the restart is noticed",
                GatewayWorld.WAIT_S,
                () -> world.has(FleetEvent.Restarted.class, news -> true));
        world.until("it is linked again", BOAT, BoatProxy::isCommanding);
        assertThat(boat.isArmed()).isFalse();
        world.tell(BOAT, BoatProxy::confirmRestart);
        completes("p3");
    }

    @Test
    void restartInASilenceIsNoticedThoughItsClockShowsAsMuchAsBefore() throws Exception {
        try (SmallBoat slow = new SmallBoat(8, START.latDeg(), START.lonDeg(), 1)) {
            world.connect(slow.address());
            world.untilReady("mav8");

            slow.switchOff();
            long offMs = ProcessClock.ms();
            world.until("the link is lost", "mav8", proxy -> proxy.status().link() == LinkState.LOST);
            Await.until("its clock is behind", GatewayWorld.WAIT_S, () -> ProcessClock.ms() - offMs > BEHIND_MS);
            slow.switchOn();

            Await.until(
                    "the restart is noticed",
                    GatewayWorld.WAIT_S,
                    () -> world.has(FleetEvent.Restarted.class, news -> true));
            world.untilReady("mav8");
        }
    }

    @Test
    void itsSilenceIsALostLink() {
        boat.reports().silent(true);

        world.until("the link is lost", BOAT, proxy -> proxy.status().link() == LinkState.LOST);
        boat.reports().silent(false);
        world.untilReady(BOAT);
    }

    private void connectNextBase() {
        world = new GatewayWorld(folder, "base-2");
        world.connect(boat.address() + "/7");
        world.untilReady(BOAT);
    }

    private void goesOnAlong(String list) {
        world.tell(BOAT, proxy -> proxy.commands().knownList(list));
        submit(path(FIRST, SECOND, THIRD));
        completes("p3");
    }

    @Test
    void baseThatComesAfterOneThatDiedGoesOnWithoutSendingAgain() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);
        String list = world.list(BOAT);
        world.close();

        connectNextBase();
        goesOnAlong(list);

        assertThat(boat.mission().uploads()).isEqualTo(1);
        assertThat(boat.armings()).isEqualTo(1);
    }

    @Test
    void handSteersItInManualAndItStopsWhenTheHandIsStill() {
        world.tell(BOAT, proxy -> proxy.teleoperate(0.5, 0));
        Await.until("it moves", GatewayWorld.WAIT_S, () -> boat.movedM() > 1);
        assertThat(boat.mode()).isEqualTo(MANUAL);

        Await.until("it is disarmed", GatewayWorld.WAIT_S, () -> !boat.isArmed() && boat.mode() == HOLD);
    }

    @Test
    void isAskedAgainWhenItNoLongerSaysWhereItIs() {
        boat.reports().forgetPosition();

        Await.until(
                "it says again where it is",
                GatewayWorld.WAIT_S,
                () -> boat.reports().hasPosition());
    }

    @Test
    void silentVehicleIsNotOrderedToKeepItsPlace() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        boat.reports().silent(true);
        world.until("the link is lost", BOAT, proxy -> proxy.status().link() == LinkState.LOST);
        boat.reports().silent(false);

        completes("p3");
        assertThat(boat.orderedModes()).doesNotContain(LOITER);
    }

    @Test
    void givenUpPathHasItKeepItsPlace() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        world.tell(BOAT, proxy -> proxy.handOver().observe());

        Await.until("it keeps its place", GatewayWorld.WAIT_S, () -> boat.mode() == LOITER);
    }

    @Test
    void whatItDoesWithoutALinkIsReadAndSetInItsParameters() {
        world.until(
                "it says what it does",
                BOAT,
                proxy -> proxy.settings().inForce().orElseThrow().lostLinkAction() == LostLinkAction.CONTINUE);

        world.tell(BOAT, proxy -> proxy.settings().setLostLinkAction(LostLinkAction.RETURN));

        world.until(
                "it returns from now on",
                BOAT,
                proxy -> proxy.settings().inForce().orElseThrow().lostLinkAction() == LostLinkAction.RETURN);
        assertThat(boat.parameter("FS_GCS_ENABLE")).isEqualTo(1);
        assertThat(boat.parameter("FS_ACTION")).isEqualTo(3);
    }

    @Test
    void baseThatComesAfterOneThatDiedKnowsThatItHasNotStartedAgain() {
        String before = world.ask(BOAT, proxy -> proxy.status().bootId());
        world.close();

        connectNextBase();

        assertThat(world.<String>ask(BOAT, proxy -> proxy.status().bootId())).isEqualTo(before);
    }

    @Test
    void baseThatEndsHasItKeepItsPlace() {
        submit(path(FIRST, SECOND, THIRD));
        world.until("it is under way", BOAT, VehicleBoatTest::isUnderWay);

        world.close();

        Await.until("it keeps its place", GatewayWorld.WAIT_S, () -> boat.mode() == LOITER);
    }

    @Test
    void baseThatComesAfterOneThatEndedGoesOnWhereItKeepsItsPlace() {
        submit(path(FIRST, SECOND, THIRD));
        Await.until(
                "the first point is visited",
                GatewayWorld.WAIT_S,
                () -> world.has(FleetEvent.Progressed.class, news -> news.visited() == 1));
        String list = world.list(BOAT);
        world.close();
        Await.until("it keeps its place", GatewayWorld.WAIT_S, () -> boat.mode() == LOITER);

        connectNextBase();
        goesOnAlong(list);

        assertThat(boat.mission().visited())
                .containsExactly(
                        List.of(FIRST.latDeg(), FIRST.lonDeg()),
                        List.of(SECOND.latDeg(), SECOND.lonDeg()),
                        List.of(THIRD.latDeg(), THIRD.lonDeg()));
        assertThat(boat.mission().uploads()).isEqualTo(1);
    }
}
