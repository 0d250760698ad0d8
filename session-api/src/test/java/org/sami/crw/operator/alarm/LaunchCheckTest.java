package org.sami.crw.operator.alarm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.alarm.LaunchCheck.State;
import org.sami.crw.operator.alarm.LaunchCheck.Subject;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

class LaunchCheckTest {
    private static final long NOW = 10_000;
    private static final Gains GAINS = new Gains(1, 0, 0);
    private static final LaunchFacts FACTS = facts(RobotKind.BOAT, Optional.empty());
    private static final BoatCapabilities BLIND =
            new BoatCapabilities(Map.of("panorama", "there is no camera on board"), Optional.of(List.of()));

    @Test
    void aBoatOfWhichAllIsKnownAndGoodMayBeLaunched() {
        LaunchCheck check = check(NOW, 80, BatteryLevel.NOMINAL, List.of(), LostLinkAction.HOLD, 0.5);

        assertThat(check.words()).isEqualTo("ready");
        assertThat(check.items()).extracting(LaunchCheck.Item::state).containsOnly(State.GOOD);
        assertThat(check.mayLaunch()).isTrue();
    }

    @Test
    void whatIsOldWrongOrEmptyIsBad() {
        assertThat(state(
                        check(NOW - 4000, 80, BatteryLevel.NOMINAL, List.of(), LostLinkAction.HOLD, 0.5),
                        Subject.POSITION))
                .isEqualTo(State.BAD);
        assertThat(state(check(NOW, 3, BatteryLevel.CRITICAL, List.of(), LostLinkAction.HOLD, 0.5), Subject.BATTERY))
                .isEqualTo(State.BAD);
        Alarm compass =
                new Alarm(1, Alarm.Kind.COMPASS_DOUBTFUL, "anna", "", "it goes sideways", 0, true, false, false);
        assertThat(state(
                        check(NOW, 80, BatteryLevel.NOMINAL, List.of(compass), LostLinkAction.HOLD, 0.5),
                        Subject.COMPASS))
                .isEqualTo(State.BAD);
    }

    @Test
    void whatABoatDoesWithoutALinkIsComparedWithWhatTheSessionWishes() {
        BoatSnapshot goesOn = boat(
                NOW,
                80,
                BatteryLevel.NOMINAL,
                Optional.of(new BoatTuning(
                        GAINS,
                        GAINS,
                        1,
                        LostLinkAction.CONTINUE,
                        Optional.empty(),
                        BoatCapabilities.UNKNOWN,
                        BoatPerformance.UNKNOWN,
                        "FS_GCS_ENABLE 0")));
        Optional<LostLinkAction> wish = Optional.of(LostLinkAction.RETURN);

        LaunchCheck check = LaunchCheck.of(goesOn, OptionalDouble.of(0.5), facts(RobotKind.BOAT, wish));

        assertThat(check.words())
                .isEqualTo("ready; without a link it goes on with its path, else holds its place (FS_GCS_ENABLE 0): set"
                        + " it, this session wishes that it returns to its home");
        assertThat(LaunchCheck.isAgainstWish(goesOn, wish)).isTrue();
        assertThat(LaunchCheck.isAgainstWish(goesOn, Optional.of(LostLinkAction.CONTINUE)))
                .isFalse();
        BoatSnapshot drifts = boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.DRIFT);
        assertThat(LaunchCheck.of(
                                drifts,
                                OptionalDouble.of(0.5),
                                facts(RobotKind.BOAT, Optional.of(LostLinkAction.DRIFT)))
                        .words())
                .isEqualTo("ready");
    }

    @Test
    void aBoatThatWouldDriftOrDidNotMoveIsDoubtfulAndMayBeLaunched() {
        LaunchCheck check = check(NOW, 25, BatteryLevel.LOW, List.of(), LostLinkAction.DRIFT, 0.0);

        assertThat(state(check, Subject.LOST_LINK)).isEqualTo(State.DOUBTFUL);
        assertThat(state(check, Subject.MOTOR)).isEqualTo(State.DOUBTFUL);
        assertThat(state(check, Subject.BATTERY)).isEqualTo(State.DOUBTFUL);
        assertThat(check.mayLaunch()).isTrue();
    }

    @Test
    void whatWasNeverHeardIsUnknownAndKeepsTheBoatAshore() {
        LaunchCheck check =
                LaunchCheck.of(boat(NOW, 80, BatteryLevel.NOMINAL, Optional.empty()), OptionalDouble.empty(), FACTS);

        assertThat(state(check, Subject.LOST_LINK)).isEqualTo(State.UNKNOWN);
        assertThat(state(check, Subject.MOTOR)).isEqualTo(State.UNKNOWN);
        assertThat(check.mayLaunch()).isFalse();
        assertThat(check.isReady()).isFalse();
        assertThat(check.words()).isEqualTo("without a link it has not said what it does");
    }

    @Test
    void aMotorThatNobodyTriedKeepsABoatAshoreAndOutOfNoMission() {
        LaunchCheck check =
                LaunchCheck.of(boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.HOLD), OptionalDouble.empty(), FACTS);

        assertThat(check.mayLaunch()).isFalse();
        assertThat(check.isReady()).isTrue();
        assertThat(check.words()).isEqualTo("ready");
    }

    @Test
    void oneLineSaysAllThatKeepsABoatFromAMissionOrElseWhatIsDoubtful() {
        assertThat(check(NOW - 4000, 3, BatteryLevel.CRITICAL, List.of(), LostLinkAction.DRIFT, 0.5)
                        .words())
                .isEqualTo("position: 45.000000, 10.000000 was 4 s ago: wait for its satellites; "
                        + "battery 3 %: put a full one in");
        assertThat(check(NOW, 25, BatteryLevel.LOW, List.of(), LostLinkAction.HOLD, 0.5)
                        .words())
                .isEqualTo("ready; battery 25 %, low: a short way only");
    }

    @Test
    void silentControlBoardIsNamedAndABoatWithoutOneIsNotAskedForIt() {
        Optional<BoatTuning> silent =
                Optional.of(new BoatTuning(GAINS, GAINS, 1, LostLinkAction.HOLD, Optional.of(BoardCondition.SILENT)));
        LaunchCheck check = LaunchCheck.of(boat(NOW, 80, BatteryLevel.NOMINAL, silent), OptionalDouble.of(0.5), FACTS);

        assertThat(check.isReady()).isFalse();
        assertThat(check.words()).isEqualTo("control board is silent: look at its power and its cable");
        assertThat(check(NOW, 80, BatteryLevel.NOMINAL, List.of(), LostLinkAction.HOLD, 0.5)
                        .items())
                .extracting(LaunchCheck.Item::subject)
                .doesNotContain(Subject.BOARD);
    }

    @Test
    void whatABoatCannotDoIsNamedAndKeepsItFromNothing() {
        Optional<BoatTuning> blind = Optional.of(
                new BoatTuning(GAINS, GAINS, 1, LostLinkAction.HOLD, Optional.empty(), BLIND, BoatPerformance.UNKNOWN));
        LaunchCheck check = LaunchCheck.of(boat(NOW, 80, BatteryLevel.NOMINAL, blind), OptionalDouble.of(0.5), FACTS);

        assertThat(check.isReady()).isTrue();
        assertThat(check.words()).isEqualTo("ready; cannot take pictures all round: there is no camera on board");
    }

    @Test
    void boatThatCannotDoWhatAPlanAsksIsNamedBeforeTheMission() {
        Optional<BoatTuning> blind = Optional.of(
                new BoatTuning(GAINS, GAINS, 1, LostLinkAction.HOLD, Optional.empty(), BLIND, BoatPerformance.UNKNOWN));
        List<BoatSnapshot> boats = List.of(boat(NOW, 80, BatteryLevel.NOMINAL, blind));
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

        assertThat(missing(library, "look-around", boats))
                .containsExactly("anna cannot take pictures all round: there is no camera on board");
        assertThat(missing(library, "clv", boats)).isEmpty();
        assertThat(missing(library, "look-around", List.of(boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.HOLD))))
                .isEmpty();
    }

    @Test
    void whatSubMissionsAskIsLookedAtToo() {
        Optional<BoatTuning> blind = Optional.of(
                new BoatTuning(GAINS, GAINS, 1, LostLinkAction.HOLD, Optional.empty(), BLIND, BoatPerformance.UNKNOWN));
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project around = library.projectOf("look-around").orElseThrow();
        Project team = library.projectOf("explore-team").orElseThrow();
        Plan parent = team.plan("explore-team").orElseThrow();
        Plan child = around.plan("look-around").orElseThrow().withId("avoid-boat");

        assertThat(MissingCapabilities.of(
                                parent,
                                team.withPlans(List.of(parent, child)),
                                List.of(boat(NOW, 80, BatteryLevel.NOMINAL, blind)),
                                RobotKind.BOAT)
                        .missing())
                .containsExactly("anna cannot take pictures all round: there is no camera on board");
    }

    private static List<String> missing(DomainLibrary library, String id, List<BoatSnapshot> boats) {
        Project project = library.projectOf(id).orElseThrow();
        return MissingCapabilities.of(project.plan(id).orElseThrow(), project, boats, RobotKind.BOAT)
                .missing();
    }

    @Test
    void boatsOfAFleetThatAreNotReadyAreCountedAndNamed() {
        BoatSnapshot good = boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.HOLD);
        BoatSnapshot empty = boat(NOW, 3, BatteryLevel.CRITICAL, LostLinkAction.HOLD);

        assertThat(FleetCheck.of(List.of(good), FACTS).words()).isEmpty();
        FleetCheck check = FleetCheck.of(List.of(empty), FACTS);
        assertThat(check.words()).isEqualTo("1 of 1 boat is not ready: anna");
        assertThat(check.reasons()).containsExactly("anna: battery 3 %: put a full one in");
    }

    @Test
    void robotThatFliesIsCheckedForItsTakeOffAndNobodyTriesItsMotors() {
        BoatSnapshot copter =
                boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.RETURN).flying(true);

        LaunchCheck check = LaunchCheck.of(copter, OptionalDouble.empty(), facts(RobotKind.COPTER, Optional.empty()));

        assertThat(check.items())
                .extracting(LaunchCheck.Item::subject)
                .containsExactly(
                        Subject.LINK,
                        Subject.COMMANDER,
                        Subject.POSITION,
                        Subject.AUTOPILOT,
                        Subject.BATTERY,
                        Subject.LOST_LINK,
                        Subject.AREA);
        assertThat(check.items()).extracting(LaunchCheck.Item::state).containsOnly(State.GOOD);
        assertThat(check.mayLaunch()).isTrue();
        assertThat(LaunchCheck.of(copter, OptionalDouble.empty(), facts(RobotKind.ROBOT, Optional.empty()))
                        .items())
                .isEqualTo(check.items());
    }

    @Test
    void whatTheAutopilotSaysAgainstArmingKeepsACopterOnTheGroundUntilItSaysItNoLonger() {
        BoatSnapshot copter =
                boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.RETURN).flying(true);
        OperatorMessage said = new OperatorMessage(
                NOW - 30_000,
                Ids.NONE,
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                "anna says: PreArm: GPS 1: Bad fix",
                List.of("anna"),
                "");

        assertThat(LaunchCheck.of(copter, OptionalDouble.empty(), said(said, NOW))
                        .words())
                .isEqualTo("autopilot: PreArm: GPS 1: Bad fix");
        assertThat(state(LaunchCheck.of(copter, OptionalDouble.empty(), said(said, NOW + 60_000)), Subject.AUTOPILOT))
                .isEqualTo(State.GOOD);
    }

    private static LaunchFacts said(OperatorMessage message, long nowMillis) {
        return new LaunchFacts(RobotKind.COPTER, List.of(), List.of(message), Optional.empty(), nowMillis);
    }

    @Test
    void copterOutsideOfItsFenceMayNotTakeOff() {
        BoatSnapshot copter =
                boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.RETURN).flying(true);
        Alarm outside = new Alarm(1, Alarm.Kind.FENCE, "anna", "", "anna is outside", 0, true, false, false);

        assertThat(LaunchCheck.of(
                                copter,
                                OptionalDouble.empty(),
                                new LaunchFacts(RobotKind.COPTER, List.of(outside), List.of(), Optional.empty(), NOW))
                        .words())
                .isEqualTo("area: anna is outside");
    }

    @Test
    void robotOfAnotherKindThanTheSessionsIsNotReadyAndInATeamBothAre() {
        BoatSnapshot boat = boat(NOW, 80, BatteryLevel.NOMINAL, LostLinkAction.HOLD);

        assertThat(LaunchCheck.of(boat, OptionalDouble.empty(), facts(RobotKind.COPTER, Optional.empty()))
                        .words())
                .isEqualTo("is a boat, and this session flies copters");
        assertThat(LaunchCheck.of(boat.flying(true), OptionalDouble.empty(), FACTS)
                        .words())
                .isEqualTo("is a copter, and this session drives boats");
        assertThat(LaunchCheck.of(boat, OptionalDouble.empty(), facts(RobotKind.ROBOT, Optional.empty()))
                        .isReady())
                .isTrue();
    }

    @Test
    void vehicleThatTakesNoGainsIsReadyWithoutADoubt() {
        Optional<BoatTuning> fixed = Optional.of(new BoatTuning(
                GAINS,
                GAINS,
                1,
                LostLinkAction.HOLD,
                Optional.empty(),
                new BoatCapabilities(
                        Map.of(BoatCapabilities.GAINS, "its gains are parameters of its autopilot"), Optional.empty()),
                BoatPerformance.UNKNOWN));

        assertThat(LaunchCheck.of(boat(NOW, 80, BatteryLevel.NOMINAL, fixed), OptionalDouble.of(0.5), FACTS)
                        .words())
                .isEqualTo("ready");
    }

    @Test
    void vehicleThatReportsNoChargeIsReadyWithADoubtUntilItsBatteryIsCritical() {
        Optional<BoatTuning> unmeasured = Optional.of(new BoatTuning(
                GAINS,
                GAINS,
                1,
                LostLinkAction.HOLD,
                Optional.empty(),
                new BoatCapabilities(Map.of(BoatCapabilities.CHARGE, "it has no current sensor"), Optional.empty()),
                BoatPerformance.UNKNOWN));

        BoatSnapshot before = boat(NOW, 100, BatteryLevel.NOMINAL, unmeasured);
        BoatSnapshot after = boat(NOW, 0, BatteryLevel.CRITICAL, unmeasured);

        assertThat(UnknownCharge.word(before)).contains("unknown");
        assertThat(UnknownCharge.word(after)).contains("critical");
        assertThat(UnknownCharge.word(boat(NOW, 80, BatteryLevel.NOMINAL, Optional.empty())))
                .isEmpty();
        assertThat(LaunchCheck.of(before, OptionalDouble.of(0.5), FACTS).words())
                .isEqualTo("ready; battery of unknown charge: it has no current sensor");
        assertThat(LaunchCheck.of(after, OptionalDouble.of(0.5), FACTS).words())
                .isEqualTo("battery critical: put a full one in");
    }

    private static LaunchFacts facts(RobotKind robots, Optional<LostLinkAction> wish) {
        return new LaunchFacts(robots, List.of(), List.of(), wish, NOW);
    }

    private static State state(LaunchCheck check, Subject subject) {
        return check.items().stream()
                .filter(item -> item.subject() == subject)
                .findFirst()
                .orElseThrow()
                .state();
    }

    private static LaunchCheck check(
            long poseAtMillis,
            double percent,
            BatteryLevel level,
            List<Alarm> alarms,
            LostLinkAction action,
            double triedMps) {
        return LaunchCheck.of(
                boat(poseAtMillis, percent, level, action),
                OptionalDouble.of(triedMps),
                new LaunchFacts(RobotKind.BOAT, alarms, List.of(), Optional.empty(), NOW));
    }

    private static BoatSnapshot boat(long poseAtMillis, double percent, BatteryLevel level, LostLinkAction action) {
        return boat(poseAtMillis, percent, level, Optional.of(new BoatTuning(GAINS, GAINS, 1, action)));
    }

    private static BoatSnapshot boat(
            long poseAtMillis, double percent, BatteryLevel level, Optional<BoatTuning> settings) {
        return new BoatSnapshot(
                "anna",
                LinkState.LINKED,
                OptionalLong.of(NOW),
                Optional.of(new BoatPose(GeoPoint.of(45, 10), 0, 0, 0)),
                poseAtMillis,
                Optional.of(new BatteryState(percent, level)),
                Optional.of(BoatMode.STOPPED),
                Commander.THIS_BASE,
                Optional.empty(),
                0,
                0,
                new BoatExplanation(false, Cause.NO_COMMAND, "anna rests"),
                Optional.empty(),
                StopLatch.NONE,
                List.of(),
                settings);
    }
}
