package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.Gains;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Welcome;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** "Why is this boat not moving?" */
class ExplainTest {
    private static final GeoPoint HERE = GeoPoint.of(45, 10);
    private static final List<GeoPoint> POINTS = List.of(Geodesy.offset(HERE, 0, 100), Geodesy.offset(HERE, 0, 200));

    private final ScriptedBoat boat = new ScriptedBoat(event -> {});
    private final Set<Cause> seen = EnumSet.noneOf(Cause.class);

    private void assertWhy(Cause cause, String words) {
        BoatExplanation explanation = boat.proxy.explain();
        assertThat(explanation.text()).contains("boat1").contains(words);
        assertThat(explanation.cause()).isEqualTo(cause);
        assertThat(explanation.shouldMove()).isEqualTo(cause == Cause.UNDER_WAY);
        seen.add(cause);
    }

    private static FollowPath path(String id, long mission, Priority priority) {
        return FollowPath.of(id, mission, 1, POINTS, priority);
    }

    /** One boat's day: every cause that there is, one after the other. */
    @Test
    void boatOutOfReachIsNotSaidToStandButToDoWhatItIsSetTo() {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress("", 0, false));
        boat.silent(5);
        assertThat(boat.proxy.explain().text()).isEqualTo("boat1 is out of reach: the link has been lost for 5 s");

        boat.linked("b1");
        boat.says(new SettingsReport(new Gains(1, 0, 0), new Gains(1, 0, 0), 1, LostLinkAction.RETURN));
        boat.silent(5);
        assertThat(boat.proxy.explain().text())
                .isEqualTo("boat1 is out of reach: the link has been lost for 5 s; by itself it returns to its home");
    }

    @Test
    void boatThatReturnsByItselfIsNotSaidToStand() {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress("", 0, false));
        boat.says(new Telemetry(45, 10, 0, 1.5, 90, BoatMode.RETURN, 1));

        assertThat(boat.proxy.explain().text())
                .isEqualTo("boat1 returns to its home, as its link was lost: no mission wants anything of it");
    }

    @Test
    void boatThatGivesWayOnItsPathSaysToWhom() {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress("", 0, false));
        boat.proxy.commands().submit(path("c", 1, Priority.MEDIUM));
        boat.setsOut();
        boat.says(givingWay("bert"));
        assertWhy(Cause.UNDER_WAY, "0 of 2 points visited, gives way to bert");
        boat.says(givingWay(""));
        assertThat(boat.proxy.explain().text()).doesNotContain("gives way");
    }

    private static Telemetry givingWay(String to) {
        return new Telemetry(45, 10, 0, 1.5, 90, BoatMode.PATH, 1, OptionalDouble.empty(), to);
    }

    @Test
    void boatThatDrivesInItsPlaceIsNotSaidToStand() {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress("", 0, false));
        boat.says(new Telemetry(45, 10, 0, 0.8, 90, BoatMode.HOLD, 1));

        assertThat(boat.proxy.explain().text())
                .isEqualTo("boat1 keeps its place, and makes room for another boat or drives back: no mission wants"
                        + " anything of it");

        boat.says(new Telemetry(45, 10, 0, 0.2, 90, BoatMode.HOLD, 2));

        assertThat(boat.proxy.explain().text()).isEqualTo("boat1 does not move: no mission wants anything of it");
    }

    @Test
    void copterInTheAirHoversUntilAMissionHasACommandForIt() {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress("", 0, false));
        boat.says(at(30.2));

        assertThat(boat.proxy.explain().text())
                .isEqualTo("boat1 hovers 30 m high: no mission has a command for it now");
    }

    @Test
    void copterThatWasToLandAndNeverTookOffIsNotSaidToHaveArrivedAnywhere() {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress("", 0, false));
        boat.says(at(0));
        boat.proxy.commands().submit(FollowPath.of("c", 1, 1, List.of(HERE), Priority.MEDIUM));
        boat.setsOut();
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 1, true));
        boat.says(at(0));

        assertThat(boat.proxy.explain().text())
                .contains("boat1 ", "it is on the ground, where its path ended for mission 1")
                .doesNotContain("arrived");
    }

    private static Telemetry at(double altM) {
        return new Telemetry(45, 10, 0, 0, 90, BoatMode.HOLD, 1, OptionalDouble.of(altM));
    }

    @Test
    void boatThatSomebodyElseDrivesIsNotSaidToStand() {
        boat.says(new Welcome("boat1", "b1", Role.OBSERVER, ""));
        boat.says(new Telemetry(45, 10, 0, 6.6, 90, BoatMode.TELEOPERATION, 1));

        assertThat(boat.proxy.explain().text()).isEqualTo("boat1 moves at 6.6 m/s: another client commands the boat");

        boat.says(new Telemetry(45, 10, 0, 0.3, 90, BoatMode.TELEOPERATION, 2));

        assertThat(boat.proxy.explain().text()).startsWith("boat1 does not move: another client commands the boat");
    }

    /** As a vehicle whose satellites are gone: it reports no position then. */
    @Test
    void vehicleThatItsFailsafeHasTakenIsNotSaidToMoveByAnOldSpeedForAnotherClient() {
        boat.says(new Telemetry(45, 10, 0, 1.5, 90, BoatMode.HOLD, 1));
        boat.says(new Welcome(
                "boat1",
                "b1",
                Role.OBSERVER,
                "",
                "",
                false,
                Optional.of(new CommandEpoch(2, CommandEpoch.NO_BASE, "its own failsafe (HOLD)"))));

        assertThat(boat.proxy.explain().text())
                .isEqualTo("boat1 moves at 1.5 m/s: its own failsafe (HOLD) commands the boat");

        boat.alive(12);

        assertThat(boat.proxy.explain().text())
                .isEqualTo("boat1 has not said for 12 s where it is: its own failsafe (HOLD) commands the boat");
    }

    @Test
    void everyCauseIsNamed() {
        assertWhy(Cause.NEVER_ANSWERED, "has not answered yet");
        boat.says(new Goodbye("boat1", "too many clients"));
        assertWhy(Cause.REFUSES, "too many clients");
        boat.says(new Welcome("boat1", "b1", Role.OBSERVER, ""));
        assertWhy(Cause.COMMANDED_ELSEWHERE, "another client commands");
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        assertWhy(Cause.COMPARING, "has not said yet what it holds");
        boat.says(new Progress("", 0, false));
        assertWhy(Cause.NO_COMMAND, "no mission wants anything");

        boat.proxy.commands().submit(path("n", 1, Priority.MEDIUM).in(Water.open(HERE)));
        assertWhy(Cause.NO_POSITION, "it has not said where it is");
        boat.proxy.commands().withdraw(1);
        boat.proxy.commands().submit(path("c", 1, Priority.MEDIUM));
        assertWhy(Cause.UPLOADING, "boat1 waits to follow its path for mission 1: the path is being uploaded");
        boat.setsOut();
        assertWhy(Cause.UNDER_WAY, "0 of 2 points visited");
        boat.onPathAt(HERE, 80, 90);
        assertWhy(Cause.NO_PROGRESS, "no nearer to point 1 for 89 s");
        boat.says(new BatteryReport(0, BatteryLevel.CRITICAL));
        boat.onPathAt(HERE, 0, 2);
        assertWhy(Cause.BATTERY_EMPTY, "its battery is empty; it should follow its path for mission 1");
        boat.says(new BatteryReport(90, BatteryLevel.NOMINAL));
        boat.silent(5);
        assertWhy(Cause.LINK_LOST, "the link has been lost for 5 s; one command waits");
        boat.linked("b2");
        assertWhy(Cause.STARTED_ANEW, "nobody has allowed it to move again; one command waits");
        boat.proxy.confirmRestart();
        boat.proxy.teleoperate(1, 0);
        assertWhy(Cause.TAKEN_OVER, "driven by hand");
        assertThat(boat.proxy.explain().text()).doesNotContain("does not move");
        boat.proxy.release();
        boat.says(new Telemetry(45, 10, 0, 0, 90, BoatMode.FLEET_STOP, 1));
        assertWhy(Cause.FLEET_STOPPED, "it is stopped, not from here, until it is released");
        boat.says(new Telemetry(45, 10, 0, 0, 90, BoatMode.STOPPED, 1));

        boat.proxy.commands().withdraw(1);
        assertWhy(Cause.STOPPING, "being stopped");
        boat.acknowledges(StopMotors.class);
        assertWhy(Cause.WITHDRAWN, "; following its path for mission 1 was withdrawn");
        boat.proxy.servesPlansOf(RobotKind.COPTER);
        assertWhy(Cause.OTHER_KIND, "is a boat, and this session flies copters");
        boat.proxy.servesPlansOf(RobotKind.ROBOT);
        boat.proxy.commands().submit(path("d", 1, Priority.MEDIUM));
        boat.setsOut();
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 2, true));
        assertWhy(Cause.ARRIVED, "it has arrived at the end of its path for mission 1");
        boat.proxy.commands().submit(path("e", 1, Priority.MEDIUM));
        boat.says(new Nack(boat.last(UploadWaypoints.class).commandId(), NackReason.TOO_LONG, "at most 1 point"));
        boat.acknowledges(StopMotors.class);
        assertWhy(
                Cause.FAILED,
                "; following its path for mission 1 failed: the boat refused it: TOO_LONG, at most 1 point");
        boat.proxy.commands().submit(new KeepStation("k", 4, 1, HERE, 10, Priority.MEDIUM, true));
        boat.setsOut();
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 1, true));
        assertWhy(Cause.KEEPS_STATION, "boat1 keeps its station for mission 4");
        boat.proxy.commands().submit(new Panorama("v", 4, 1, 8, Priority.MEDIUM));
        boat.acknowledges(TakePanorama.class);
        assertWhy(Cause.TAKES_PICTURES, "boat1 takes pictures all round for mission 4: turning all round");
        boat.proxy.commands().submit(new Stop("s", 4, 1, Priority.LOW, true));
        boat.acknowledges(StopMotors.class);
        assertWhy(Cause.BLOCKED, "mission 4 keeps it where it is");

        assertThat(seen).containsExactlyInAnyOrder(Cause.values());
    }

    @Test
    void itSaysForWhomTheOtherMissionsWait() {
        boat.linked("b1");
        boat.proxy.commands().submit(path("c", 1, Priority.MEDIUM));
        boat.proxy.commands().submit(path("later", 2, Priority.MEDIUM));
        boat.proxy.commands().submit(path("lesser", 3, Priority.LOW));
        boat.proxy.commands().submit(path("now", 4, Priority.CRITICAL));
        boat.setsOut();

        assertThat(boat.proxy.explain().text())
                .startsWith("boat1 follows its path for mission 4: under way")
                .contains("; following its path for mission 1 waits: it is interrupted and returns afterwards")
                .contains("; following its path for mission 2 waits: its priority is MEDIUM, not CRITICAL")
                .contains("; following its path for mission 3 waits: its priority is LOW, not CRITICAL");

        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 2, true));
        assertThat(boat.proxy.explain().text())
                .contains("; following its path for mission 2 waits: the other came first");
    }

    @Test
    void itSaysWhichMissionKeepsTheBoatFromTheOthers() {
        boat.linked("b1");
        boat.proxy.commands().submit(path("c", 1, Priority.MEDIUM).blocking());
        boat.proxy.commands().submit(path("other", 2, Priority.HIGH));
        boat.setsOut();

        assertThat(boat.proxy.explain().text())
                .endsWith("; following its path for mission 2 waits: mission 1 keeps the boat");
        assertThat(boat.proxy
                        .explain(mission -> Optional.of(mission == 1 ? "Survey" : "Return"))
                        .text())
                .endsWith("; following its path for mission 2, Return waits: mission 1, Survey keeps the boat");
    }

    @Test
    void missionsAreToldByTheirPlansAndTheOperatorByNone() {
        MissionTitles titles = mission -> Optional.of(mission == 1 ? "Explore Area" : "Return");
        boat.linked("b1");
        boat.proxy.commands().submit(path("m1-a3-anna", 1, Priority.MEDIUM));
        boat.proxy.commands().submit(path("m2-a1-anna", 2, Priority.LOW));
        boat.setsOut();
        assertThat(boat.proxy.explain(titles).text())
                .startsWith("boat1 follows its path for mission 1, Explore Area: under way, 0 of 2 points visited")
                .contains("; following its path for mission 2, Return waits: ")
                .doesNotContain("m1-a3-anna", "m2-a1-anna");

        boat.proxy.commands().withdraw(1);
        boat.proxy.commands().withdraw(2);
        boat.acknowledges(StopMotors.class);
        assertThat(boat.proxy.explain(titles).text())
                .endsWith("; following its path for mission 2, Return was withdrawn");

        boat.proxy.commands().submit(path("go", Ids.NONE, Priority.MEDIUM));
        boat.setsOut();
        assertThat(boat.proxy.explain(titles).text()).isEqualTo("boat1 goes where the operator sent it: under way");
    }
}
