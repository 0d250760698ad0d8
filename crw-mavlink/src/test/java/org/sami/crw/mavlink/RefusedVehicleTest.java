package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** What a base says of vehicles that it does not command, and that it does not take them for connected. */
@Timeout(900)
class RefusedVehicleTest {
    @TempDir
    private Path folder;

    private SmallBoat boat;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
    }

    private void isSaid(GatewayWorld world, String words, Runnable meanwhile) {
        Await.until(words, GatewayWorld.WAIT_S, () -> {
            meanwhile.run();
            return world.links().stream().anyMatch(link -> link.lastEvent().contains(words));
        });
        assertThat(world.links()).allMatch(link -> link.boatId().isEmpty());
    }

    @Test
    void vehicleThatSpeaksTheFirstVersionOnlyIsNotConnectedAndToldWhatToSet() {
        boat.speakFirstVersion();
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address());

            isSaid(world, "it speaks MAVLink 1 only; set the autopilot's port to MAVLink 2", () -> {});
        }
    }

    @Test
    void vehicleOfAnotherAutopilotIsRefusedByItsName() {
        boat.reports().steeredByPx4();
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address());

            isSaid(world, "vehicle 5 has the autopilot PX4, and here only ArduPilot's vehicles", () -> {});
        }
    }
}
