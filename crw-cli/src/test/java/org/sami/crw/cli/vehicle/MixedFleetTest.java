package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.value.GeoPoint;

/** A simulated boat over TCP and one that speaks MAVLink, in one plan. */
@Timeout(900)
class MixedFleetTest {
    private static final GeoPoint PIER = GeoPoint.of(45.7, 10.72);

    @Test
    void onePlanRunsOnBoatsOfBothKinds() throws Exception {
        SimulatedBoatsOnTcp simulated = new SimulatedBoatsOnTcp(1);
        try (SmallBoat vehicle = new SmallBoat(9, PIER.latDeg(), PIER.lonDeg() + 0.0002, 3)) {
            String both = simulated.launch("anna", PIER) + "," + vehicle.address() + "/9";

            CommandResult ran = CommandResult.crw("run", "clv", "--connect", both, "--area", "30", "--locations", "4");

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out())
                    .contains("locations visited   4 of 4")
                    .containsPattern("anna +\\d+ m")
                    .containsPattern("mav9 +\\d+ m");
            assertThat(vehicle.movedM()).isGreaterThan(3);
        } finally {
            simulated.close();
        }
    }
}
