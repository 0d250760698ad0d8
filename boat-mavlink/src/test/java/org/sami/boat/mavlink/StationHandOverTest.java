package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.mavlink.DrivenBoat.LAT;
import static org.sami.boat.mavlink.DrivenBoat.LON;
import static org.sami.boat.mavlink.DrivenBoat.OTHER;
import static org.sami.boat.mavlink.DrivenBoat.STATION;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardModes;
import org.sami.mavlink.onboard.StationOrder;

/** A base hands over to a ground station, or is lost while a station asks. */
class StationHandOverTest {
    private final DrivenBoat boat = new DrivenBoat(LostLinkAction.DRIFT);
    private final DrivenBoat.Base base = boat.base(Role.COMMANDER);

    @Test
    void anOperatorWhoAnswersAfterAWhileHandsOverToTheStationThatAsked() {
        base.send(HoldPosition::new);
        assertThat(boat.mode(OTHER, OnboardModes.LOITER).isAccepted()).isFalse();
        assertThat(boat.mode(STATION, OnboardModes.LOITER).isAccepted()).isFalse();
        assertThat(base.isAsked()).isTrue();
        boat.pass(20_000, STATION, OTHER);

        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(10_000, STATION);
        assertThat(boat.command.isHolder(STATION)).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD); // no lost link
        assertThat(boat.vehicle.isArmed()).isTrue();
    }

    @Test
    void anOperatorWhoHandsOverUnaskedHandsOverToTheStationThatIsThere() {
        base.send(HoldPosition::new);
        boat.pass(5_000, OTHER);

        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(10_000, OTHER);
        assertThat(boat.command.isHolder(OTHER)).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void aStationThatIsGoneWhenTheOperatorAnswersIsALostLink() {
        base.send(HoldPosition::new);
        boat.mode(STATION, OnboardModes.LOITER);
        boat.pass(10_000);

        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(5_000);
        assertThat(boat.command.isHolder(STATION)).isFalse();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.STOPPED); // what is set for it
    }

    /** The base hands over on a path of two places, which stations are shown as the mission. */
    private void handOverOnAPath() {
        List<Waypoint> path = List.of(new Waypoint(LAT + 0.005, LON, 1), new Waypoint(LAT + 0.01, LON, 1));
        base.send(id -> new UploadWaypoints(id, "path", path));
        base.send(id -> new StartWaypoints(id, "path", 0));
        boat.pass(1_000, STATION);
        boat.mission.show(MissionPath.missionOf(boat.client.waypoints(), boat.vehicle.home()), "path");

        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(1_000, STATION);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.PATH);
        assertThat(boat.vehicle.mode()).isEqualTo(OnboardModes.AUTO);
    }

    @Test
    void aBoatThatWasHandedOverOnAPathKeepsItsPlaceWhenItIsSentAMission() {
        handOverOnAPath();

        boat.mission(MissionItem.waypoint(1, LAT - 0.001, LON, 0, 0));
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(boat.vehicle.mode()).isEqualTo(OnboardModes.LOITER);
    }

    @Test
    void aBoatThatWasHandedOverOnAPathGoesOnAtTheItemAndAtTheSpeedThatAStationNames() {
        handOverOnAPath();

        assertThat(boat.order(STATION, new StationOrder.ChangeSpeed(0.5)).isAccepted())
                .isTrue();
        assertThat(boat.client.waypoints()).hasSize(2).allMatch(leg -> leg.speedMps() == 0.5);
        handOverAgain();
        assertThat(boat.order(STATION, new StationOrder.GoOnAt(2)).isAccepted()).isTrue();
        assertThat(boat.client.takeProgress())
                .last()
                .satisfies(now -> assertThat(now.nextIndex()).isOne());
        assertThat(boat.server.mode()).isEqualTo(BoatMode.PATH);
    }

    /** The base takes the command of a boat on its way, and gives it back. */
    private void handOverAgain() {
        base.send(id -> new TakeCommand(id, "s1", 9));
        boat.pass(500, STATION);
        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(500, STATION);
        assertThat(boat.command.isHolder(STATION)).isTrue();
        assertThat(boat.server.mode()).isEqualTo(BoatMode.PATH);
    }

    @Test
    void aBoatThatWasHandedOverOnAPathKeepsItsPlaceWhereANewFenceLiesAcrossIt() {
        handOverOnAPath();

        boat.fence(FencePart.list(FencePart.square(FencePart.INCLUSION, LAT, LON, 0.002))
                .toArray(new MissionItem[0]));
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void anotherSpeedStartsNoMissionThatTheBoatDoesNotDriveYet() {
        handOverOnAPath();
        base.send(id -> new TakeCommand(id, "s1", 9));
        boat.pass(500, STATION);
        boat.mission(MissionItem.waypoint(1, LAT - 0.001, LON, 0, 0));
        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(500, STATION);

        assertThat(boat.order(STATION, new StationOrder.ChangeSpeed(0.5)).isAccepted())
                .isTrue();
        assertThat(boat.client.waypoints()).hasSize(2);
    }

    @Test
    void theWishItselfTakesNoCommandFromABaseThatIsJustLost() {
        boat.pass(500);
        BoatClient late = new BoatClient(boat.server, boat.nowMs); // it has heard of the base's number
        CommandingStation command = new CommandingStation(late, "anna", (severity, text) -> {}, won -> {}, boat.nowMs);
        base.falls();
        boat.nowMs += 4_000; // a process that stood still: the boat notices with the next frame

        assertThat(command.take(STATION, boat.nowMs)).isPresent();
        assertThat(boat.server.hasCommander()).isFalse();
        assertThat(command.take(STATION, boat.nowMs))
                .hasValueSatisfying(why -> assertThat(why).startsWith("base1 commands anna, lost"));
    }
}
