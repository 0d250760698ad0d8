package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** Which parameters of a vehicle have it avoid others by itself. */
class VehicleAvoidanceTest {
    @Test
    void avoidanceAsDeliveredWithoutAProximitySensorIsNoConflict() {
        assertThat(VehicleAvoidance.conflict(Map.of("OA_TYPE", 0L, "AVOID_ENABLE", 3L, "PRX1_TYPE", 0L)))
                .isEmpty();
    }

    @Test
    void aProximitySensorThatIsAvoidedByIsNamed() {
        assertThat(VehicleAvoidance.conflict(Map.of("OA_TYPE", 0L, "AVOID_ENABLE", 3L, "PRX1_TYPE", 4L)))
                .hasValueSatisfying(text -> assertThat(text).contains("AVOID_ENABLE 3, PRX1_TYPE 4"));
    }

    @Test
    void aProximitySensorThatOnlyReportsIsNoConflict() {
        assertThat(VehicleAvoidance.conflict(Map.of("OA_TYPE", 0L, "AVOID_ENABLE", 1L, "PRX1_TYPE", 4L)))
                .isEmpty();
    }

    @Test
    void waysThatTheAutopilotPlansAreNamed() {
        assertThat(VehicleAvoidance.conflict(Map.of("OA_TYPE", 1L)))
                .hasValueSatisfying(text -> assertThat(text).contains("OA_TYPE 1"));
    }

    @Test
    void aFirmwareWithoutTheseParametersIsNoConflict() {
        assertThat(VehicleAvoidance.conflict(Map.of())).isEmpty();
    }

    @Test
    void boatThatPlansWaysByItselfIsNamedWhenABaseComes(@TempDir Path folder) throws Exception {
        try (SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 20);
                GatewayWorld world = new GatewayWorld(folder)) {
            boat.parameter("OA_TYPE", 1);
            world.connect(boat.address());
            world.untilReady("mav7");

            Await.until(
                    "it is named",
                    () -> world.alarms.stream()
                            .anyMatch(
                                    text -> text.startsWith("mav7 plans ways around obstacles by itself (OA_TYPE 1)")));
        }
    }
}
