package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.mavlink.DrivenBoat.OTHER;
import static org.sami.boat.mavlink.DrivenBoat.STATION;

import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.mavlink.onboard.OnboardModes;

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
