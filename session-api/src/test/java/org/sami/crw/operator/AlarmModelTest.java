package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.TurnWait;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What raises an alarm and what ends it, on poses and queues that the test says. */
class AlarmModelTest {
    private static final GeoPoint HOME = GeoPoint.of(45.6, 10.68);
    private static final double NORTH = 0;
    private static final double EAST = Math.PI / 2;

    private final ModelWorld world = new ModelWorld();
    private final OperatorModels models = world.models;
    private double batteryPercent = 90;
    private Optional<BoatTuning> settings = Optional.empty();
    private BatteryLevel level = BatteryLevel.NOMINAL;
    private Optional<BoatCommand> command = Optional.empty();
    private int visited;
    private boolean flies;
    private Cause cause = Cause.UNDER_WAY;

    @BeforeEach
    void timeHasPassed() {
        world.nowMillis.set(100_000);
        models.look();
        world.settle();
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(HOME, eastM, northM);
    }

    private static GeoArea square(double fromM, double toM) {
        return new GeoArea(List.of(at(fromM, fromM), at(toM, fromM), at(toM, toM), at(fromM, toM)), List.of());
    }

    private void see(String boat, GeoPoint where, double headingRad, double speedMps) {
        long now = world.nowMillis.get();
        models.fleet()
                .seen(
                        boat,
                        Optional.of(new BoatSnapshot(
                                        boat,
                                        LinkState.LINKED,
                                        OptionalLong.of(now),
                                        Optional.of(new BoatPose(where, headingRad, speedMps, now)),
                                        now,
                                        Optional.of(new BatteryState(batteryPercent, level)),
                                        Optional.empty(),
                                        Commander.THIS_BASE,
                                        command,
                                        visited,
                                        0,
                                        new BoatExplanation(true, cause, ""),
                                        Optional.empty(),
                                        StopLatch.NONE,
                                        List.of(),
                                        settings)
                                .flying(flies)));
        world.settle();
    }

    private void later(double seconds) {
        world.nowMillis.addAndGet((long) (seconds * 1000));
    }

    private Optional<Alarm> alarm(Kind kind) {
        return models.alarms().snapshot().stream()
                .filter(alarm -> alarm.kind() == kind)
                .findFirst();
    }

    private boolean isActive(Kind kind) {
        return alarm(kind).filter(Alarm::active).isPresent();
    }

    private FollowPath path(GeoPoint... points) {
        return FollowPath.of("m3-a1-anna", 3, 1, List.of(points), Priority.MEDIUM);
    }

    /** The boat's queue holds this path now, of which so many points are behind it. */
    private void queued(FollowPath path, int behind) {
        world.events.publish(new FleetEvent.QueueChanged(
                "anna",
                new CommandQueueSnapshot(
                        Optional.of(new CommandQueueSnapshot.Entry(
                                path, behind, path.points().size(), TurnWait.NOT)),
                        List.of(),
                        OptionalLong.empty())));
        world.settle();
    }

    @Test
    void chargeThatDoesNotLastForTheWayAheadIsAnAlarmUntilEnoughOfItIsBehind() {
        command = Optional.of(path(at(0, 500), at(0, 1000)));
        batteryPercent = 20; // for 700 m
        see("anna", HOME, NORTH, 1);
        assertThat(alarm(Kind.RANGE)).map(Alarm::text).get().asString().contains("about 1000 m", "about 700 m");

        visited = 1;
        see("anna", at(0, 505), NORTH, 1);
        assertThat(isActive(Kind.RANGE)).isFalse();
    }

    @Test
    void chargeOfACopterIsSaidToLastForNoDistance() {
        flies = true;
        command = Optional.of(path(at(0, 500), at(0, 1000)));
        batteryPercent = 20;
        level = BatteryLevel.LOW;
        see("anna", HOME, NORTH, 1);

        assertThat(isActive(Kind.RANGE)).isFalse();
        assertThat(alarm(Kind.BATTERY_LOW)).map(Alarm::text).contains("The battery of anna is low: 20 %");
    }

    @Test
    void batteryAlarmSaysHowFarItLastsForABoatThatSaysItsRange() {
        batteryPercent = 20;
        level = BatteryLevel.LOW;
        Gains gains = new Gains(1, 0, 0);
        settings = Optional.of(new BoatTuning(
                gains,
                gains,
                1,
                LostLinkAction.HOLD,
                Optional.empty(),
                BoatCapabilities.UNKNOWN,
                new BoatPerformance(OptionalDouble.of(180), OptionalDouble.empty(), OptionalDouble.empty())));
        see("anna", HOME, NORTH, 0);

        assertThat(alarm(Kind.BATTERY_LOW))
                .map(Alarm::text)
                .contains("The battery of anna is low: 20 %, for about 3600 m");
    }

    @Test
    void batteryAlarmOfAVehicleThatReportsNoChargeSaysWhoHasFoundItCritical() {
        batteryPercent = 0;
        level = BatteryLevel.CRITICAL;
        Gains gains = new Gains(1, 0, 0);
        settings = Optional.of(new BoatTuning(
                gains,
                gains,
                1,
                LostLinkAction.HOLD,
                Optional.empty(),
                new BoatCapabilities(Map.of(BoatCapabilities.CHARGE, "it has no current sensor"), Optional.empty()),
                BoatPerformance.UNKNOWN));
        see("anna", HOME, NORTH, 0);

        assertThat(alarm(Kind.BATTERY_CRITICAL))
                .map(Alarm::text)
                .contains("The battery of anna is critical by its autopilot's own limits");
    }

    @Test
    void batteryAlarmSaysHowFarItLasts() {
        batteryPercent = 21;
        level = BatteryLevel.LOW;
        see("anna", HOME, NORTH, 0);
        assertThat(alarm(Kind.BATTERY_LOW))
                .map(Alarm::text)
                .contains("The battery of anna is low: 21 %, for about 700 m");

        level = BatteryLevel.CRITICAL;
        see("anna", HOME, NORTH, 0);
        assertThat(isActive(Kind.BATTERY_LOW)).isFalse();
        assertThat(isActive(Kind.BATTERY_CRITICAL)).isTrue();
    }

    @Test
    void boatWhoseLinkStandsAndThatDoesNotSayWhereItIsIsAnAlarm() {
        see("anna", HOME, NORTH, 0);
        later(4.9);
        models.look();
        world.settle();
        assertThat(alarm(Kind.STALE_POSE)).isEmpty();

        later(0.5);
        models.look();
        world.settle();
        assertThat(isActive(Kind.STALE_POSE)).isTrue();

        see("anna", HOME, NORTH, 0);
        models.look();
        world.settle();
        assertThat(isActive(Kind.STALE_POSE)).isFalse();
    }

    @Test
    void positionThatJumpsIsDoubtfulForTenSeconds() {
        see("anna", HOME, NORTH, 1);
        later(1);
        see("anna", at(0, 15), NORTH, 1); // a boat and its noise
        assertThat(alarm(Kind.POSITION_DOUBTFUL)).isEmpty();

        later(1);
        see("anna", at(300, 0), NORTH, 1);
        assertThat(alarm(Kind.POSITION_DOUBTFUL))
                .map(Alarm::text)
                .get()
                .asString()
                .contains("jumped by 300 m");

        for (int s = 0; s < 10; s++) {
            later(1);
            see("anna", at(300, s + 1), NORTH, 1);
        }
        assertThat(isActive(Kind.POSITION_DOUBTFUL)).isFalse();
    }

    @Test
    void positionThatStaysTheSameWhileTheBoatMovesIsDoubtful() {
        for (int s = 0; s < 7; s++) {
            later(1);
            see("anna", HOME, NORTH, 1);
        }
        assertThat(alarm(Kind.POSITION_DOUBTFUL))
                .map(Alarm::text)
                .get()
                .asString()
                .contains("stays the same");
    }

    @Test
    void boatThatDoesNotGoWhereItHeadsHasADoubtfulCompass() {
        for (int s = 0; s < 20; s++) {
            later(1);
            see("anna", at(s, 0), EAST + Math.toRadians(40), 1); // wind
        }
        assertThat(alarm(Kind.COMPASS_DOUBTFUL)).isEmpty();

        for (int s = 20; s < 40; s++) {
            later(1);
            see("anna", at(s, 0), NORTH, 1);
        }
        assertThat(isActive(Kind.COMPASS_DOUBTFUL)).isTrue();

        for (int s = 40; s < 50; s++) {
            later(1);
            see("anna", at(s, 0), EAST, 1);
        }
        assertThat(isActive(Kind.COMPASS_DOUBTFUL)).isFalse();
    }

    @Test
    void boatThatGoesAsternHasACompassToTrust() {
        for (int s = 0; s < 20; s++) {
            later(1);
            see("anna", at(s, 0), -EAST, -1);
        }
        assertThat(alarm(Kind.COMPASS_DOUBTFUL)).isEmpty();
    }

    @Test
    void fenceIsBrokenByPositionAndByTheWayBetweenTwoPositions() {
        world.step(OperatingArea.remember(square(-100, 100)));
        world.settle();
        see("anna", at(90, 90), EAST, 1);
        assertThat(alarm(Kind.FENCE)).isEmpty();

        later(60);
        see("anna", at(110, 90), EAST, 1);
        assertThat(alarm(Kind.FENCE)).map(Alarm::text).get().asString().contains("is outside");
        later(60);
        see("anna", at(90, 90), EAST, 1);
        assertThat(isActive(Kind.FENCE)).isFalse();

        world.step(OperatingArea.remember(new GeoArea(
                List.of(
                        at(-100, -100),
                        at(100, -100),
                        at(100, 100),
                        at(60, 100),
                        at(60, 0),
                        at(40, 0),
                        at(40, 100),
                        at(-100, 100)),
                List.of())));
        world.settle();
        later(60);
        see("anna", at(20, 90), EAST, 1);
        assertThat(alarm(Kind.FENCE)).map(Alarm::text).get().asString().contains("went through");
    }

    @Test
    void fenceIsBrokenByASegmentOfAPathBeforeTheBoatIsThere() {
        world.step(OperatingArea.remember(square(-100, 100)));
        see("anna", HOME, EAST, 1);
        FollowPath path = path(at(50, 0), at(150, 0), at(150, 50), at(50, 50), at(0, 50));
        queued(path, 0);
        assertThat(alarm(Kind.FENCE_AHEAD))
                .map(Alarm::text)
                .get()
                .asString()
                .startsWith("Mission 3 sends anna through");
        assertThat(alarm(Kind.FENCE)).isEmpty();

        queued(path, 4); // what is behind the boat is no news
        assertThat(isActive(Kind.FENCE_AHEAD)).isFalse();
    }

    @Test
    void fenceThatComesWhileBoatsLieStillIsCheckedAtOnce() {
        see("anna", at(500, 0), EAST, 0);
        world.step(OperatingArea.remember(square(-100, 100)));
        world.settle();
        assertThat(isActive(Kind.FENCE)).isTrue();

        world.step(OperatingArea.rememberNone());
        world.settle();
        assertThat(isActive(Kind.FENCE)).isFalse();
    }

    @Test
    void boatThatIsFarBeyondTheFenceIsOutsideOfItToo() {
        world.step(OperatingArea.remember(square(-100, 100)));
        world.settle();
        see("anna", GeoPoint.of(45.4, 10.9), EAST, 0); // 30 km away
        assertThat(isActive(Kind.FENCE)).isTrue();
    }

    @Test
    void fenceThatCannotBeWatchedIsAnAlarmItself() {
        world.step(OperatingArea.remember(
                new GeoArea(List.of(at(0, 0), at(100, 100), at(100, 0), at(0, 100)), List.of())));
        world.settle();

        assertThat(alarm(Kind.FENCE)).map(Alarm::text).get().asString().startsWith("No boat is held to the fence: ");
    }

    @Test
    void boatsThatAreAboutToMeetAreOneAlarmUntilTheyPart() {
        see("anna", at(0, 0), EAST, 1.5);
        see("bert", at(8, 1), -EAST, 1.5);
        assertThat(models.alarms().snapshot())
                .singleElement()
                .satisfies(alarm -> assertThat(alarm.kind()).isEqualTo(Kind.APPROACH))
                .satisfies(alarm ->
                        assertThat(List.of(alarm.boat(), alarm.other())).containsExactly("anna", "bert"))
                .satisfies(alarm ->
                        assertThat(alarm.text()).isEqualTo("anna and bert come within 1 m of each other in 3 s"));

        later(12);
        see("anna", at(18, 0), EAST, 1.5);
        see("bert", at(2, 1), -EAST, 1.5);
        assertThat(isActive(Kind.APPROACH)).isFalse();
    }

    @Test
    void boatsThatHaveTimeToGiveWayAreNoAlarm() {
        see("anna", at(0, 0), EAST, 1.5);
        see("bert", at(20, 1), -EAST, 1.5);

        assertThat(alarm(Kind.APPROACH)).isEmpty();
    }

    @Test
    void boatsThatLieSideBySideAtTheQuayAreNoAlarm() {
        see("anna", at(0, 0), EAST, 0);
        see("bert", at(1, 0), EAST, 0.1);

        assertThat(alarm(Kind.APPROACH)).isEmpty();
    }

    @Test
    void boatThatComesNoNearerOrWhoseServerStartedAnewIsAnAlarm() {
        cause = Cause.NO_PROGRESS;
        see("anna", HOME, NORTH, 1);
        assertThat(alarm(Kind.NO_PROGRESS)).map(Alarm::text).contains("anna comes no nearer to its next point");

        cause = Cause.STARTED_ANEW;
        see("anna", HOME, NORTH, 0);
        assertThat(isActive(Kind.NO_PROGRESS)).isFalse();
        assertThat(isActive(Kind.BOAT_CRITICAL)).isTrue();

        cause = Cause.UNDER_WAY;
        see("anna", HOME, NORTH, 1);
        assertThat(isActive(Kind.BOAT_CRITICAL)).isFalse();
    }

    @Test
    void boatsWithOneIdAreAnAlarmUntilOneHasMovedAway() {
        world.events.publish(new FleetEvent.LinkAlarmed(new LinkAlarm(
                LinkAlarm.Kind.TWO_BOATS_WITH_ONE_ID, "anna", new InetSocketAddress(11411), "two boats are anna")));
        world.settle();
        assertThat(alarm(Kind.DUPLICATE_ID)).map(Alarm::text).contains("two boats are anna");

        world.events.publish(new FleetEvent.Moved("anna", new InetSocketAddress(11411), new InetSocketAddress(11412)));
        world.settle();
        assertThat(isActive(Kind.DUPLICATE_ID)).isFalse();
    }

    @Test
    void acknowledgingAndMutingStandInTheOperatorsLog() {
        level = BatteryLevel.LOW;
        see("anna", HOME, NORTH, 0);
        models.alarms().acknowledge(alarm(Kind.BATTERY_LOW).orElseThrow().number());
        models.alarms().mute(Kind.BATTERY_LOW, "anna", true);
        models.alarms().mute(Kind.BATTERY_LOW, "anna", true);
        world.settle();

        assertThat(models.log().snapshot())
                .extracting(OperatorLogEntry::kind)
                .containsExactly(OperatorLogEntry.Kind.ACKNOWLEDGED, OperatorLogEntry.Kind.MUTED);
        assertThat(models.log().snapshot().get(0).boats()).containsExactly("anna");
    }
}
