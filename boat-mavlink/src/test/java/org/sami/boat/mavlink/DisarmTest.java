package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.mavlink.DrivenBoat.OTHER;
import static org.sami.boat.mavlink.DrivenBoat.STATION;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardModes;
import org.sami.mavlink.vehicle.VehicleId;

/** What disarming does, by whom a stop is undone, and how a disarmed boat stays. */
class DisarmTest {
    private final DrivenBoat boat = new DrivenBoat(LostLinkAction.HOLD);

    private void driveBy(VehicleId station) {
        driveBy(station, boat);
    }

    private static void driveBy(VehicleId station, DrivenBoat boat) {
        assertThat(boat.mode(station, OnboardModes.LOITER).isAccepted()).isTrue();
        assertThat(boat.arm(station).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void theStationThatCommandsStopsAndStartsTheBoatAsItLikes() {
        driveBy(STATION);

        assertThat(boat.disarm(STATION).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(boat.arm(STATION).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void theStopOfAStationThatDoesNotCommandIsLatchedForTheOneThatDoes() {
        driveBy(STATION);

        assertThat(boat.disarm(OTHER).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
        assertThat(boat.arm(STATION).words()).isEqualTo("anna is stopped until a base releases it");
        assertThat(boat.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
    }

    @Test
    void theStopOfABoatThatRestsForAMomentUnderABaseIsLatched() {
        DrivenBoat.Base base = boat.base(Role.COMMANDER);
        base.send(StopMotors::new);

        assertThat(boat.disarm(STATION).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
        base.send(HoldPosition::new);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
    }

    @Test
    void aBaseReleasesWhatAStationLatchedThatDidNotCommand() {
        DrivenBoat.Base base = boat.base(Role.COMMANDER);
        base.send(HoldPosition::new);
        assertThat(boat.disarm(STATION).isAccepted()).isTrue();

        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(100, STATION);
        assertThat(boat.arm(STATION).words()).isEqualTo("anna is stopped until a base releases it");

        base.send(id -> new TakeCommand(id, "s1", 9));
        base.send(FleetRelease::new);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void aStationThatCouldCommandUndoesItsOwnStop() {
        stopAfterALostLink();

        assertThat(boat.arm(STATION).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isNotEqualTo(BoatMode.FLEET_STOP);
    }

    /** The boat moves by itself, and a station stops it that may command then. */
    private void stopAfterALostLink() {
        driveBy(STATION);
        boat.pass(5_000);
        assertThat(boat.client.commands()).isFalse();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(boat.disarm(STATION).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
    }

    @Test
    void aStationDoesNotUndoAStopThatABaseHasPressedToo() {
        stopAfterALostLink();
        DrivenBoat.Base base = boat.base(Role.OBSERVER);
        base.send(FleetStop::new);

        assertThat(boat.arm(STATION).words()).isEqualTo("anna is stopped by base1 too: release it there");
        assertThat(boat.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
    }

    @Test
    void anArmThatCannotBeginLeavesTheStopLatched() {
        boat.mission(MissionItem.waypoint(1, DrivenBoat.LAT + 0.001, DrivenBoat.LON, 0, 0));
        stopAfterALostLink();
        assertThat(boat.mode(STATION, OnboardModes.AUTO).isAccepted()).isTrue();
        boat.mission();

        assertThat(boat.arm(STATION).words()).isEqualTo("there is no mission");
        assertThat(boat.server.mode()).isEqualTo(BoatMode.FLEET_STOP);
    }

    @ParameterizedTest
    @EnumSource(LostLinkAction.class)
    void aDisarmedBoatStaysAtRestWhenItsStationIsGone(LostLinkAction lostLink) {
        DrivenBoat disarmed = new DrivenBoat(lostLink);
        driveBy(STATION, disarmed);
        disarmed.pass(1_000, STATION);
        disarmed.disarm(STATION);

        disarmed.pass(10_000);
        assertThat(disarmed.client.commands()).isFalse();
        assertThat(disarmed.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void aDisarmedBoatStaysAtRestWhenItsLinkEndsOrItStoodStill() {
        driveBy(STATION);
        boat.disarm(STATION);
        boat.nowMs += 60_000; // a process that slept
        boat.server.tick(boat.nowMs);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.STOPPED);

        DrivenBoat another = new DrivenBoat(LostLinkAction.HOLD);
        driveBy(STATION, another);
        another.disarm(STATION);
        another.client.close(another.nowMs);
        assertThat(another.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void anArmedBoatAtRestDoesWhatIsSetForALostLink() {
        driveBy(STATION);
        assertThat(boat.mode(STATION, OnboardModes.HOLD).isAccepted()).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.STOPPED);

        boat.pass(5_000);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD); // motors on, at its place
    }
}
