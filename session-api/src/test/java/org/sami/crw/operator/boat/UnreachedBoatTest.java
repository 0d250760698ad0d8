package org.sami.crw.operator.boat;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class UnreachedBoatTest {
    private static final String PLANE = "vehicle 5 is a plane, and here only surface boats and copters are commanded";

    private static UnreachedBoat at(String address, String reason, boolean refused) {
        return new UnreachedBoat(address, "", reason, refused, 3, 0);
    }

    @Test
    void refusedVehicleIsNotToBeSwitchedOn() {
        UnreachedBoat plane = at("mavlink:udp:14550/5", PLANE, true);

        assertThat(plane.sentence()).isEqualTo("mavlink:udp:14550/5 is refused: " + PLANE + " (tried 3 times)");
        assertThat(plane.advice()).isEqualTo("Change what the reason names, or give the address up");
    }

    @Test
    void vehicleThatIsSilentIsToBeSwitchedOn() {
        assertThat(at("mavlink:udp:14550/5", "no vehicle 5 is heard there", false)
                        .advice())
                .startsWith("Switch the boat on, look at address and network");
    }

    @Test
    void boatWithTheIdOfAnotherIsToHaveOneOfItsOwn() {
        assertThat(at("10.0.0.9:11411", "anna is reached by another link", true).advice())
                .contains("give that boat an id of its own");
    }
}
