package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.mavlink.vehicle.VehicleHealth;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

class StalledListDetectorTest {
    private static final int STOP = 400;

    private final StalledListDetector watch = new StalledListDetector();

    private static VehicleSnapshot vehicle(int item, double speedMps) {
        return new VehicleSnapshot(
                new VehicleId(3, 1),
                VehicleKind.BOAT,
                "ArduPilot",
                "AUTO",
                true,
                true,
                Optional.of(new VehiclePosition(45.7, 10.72, 0, speedMps, Optional.empty(), 0, 0)),
                Optional.empty(),
                Optional.empty(),
                new VehicleHealth(true, false, false, Optional.empty(), List.of()),
                Optional.of(item),
                Optional.empty(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                0,
                List.of(),
                Optional.empty());
    }

    @Test
    void vehicleThatLiesAtTheGateStaysThere() {
        watch.stopReplaced(STOP);

        assertThat(watch.stays(vehicle(STOP, 0), 10_000)).isEmpty();
        assertThat(watch.stays(vehicle(STOP, 0), 12_900)).isEmpty();
        assertThat(watch.stays(vehicle(STOP, 0), 13_000)).contains(STOP);
        assertThat(watch.stays(vehicle(STOP, 0), 20_000)).isEmpty();
    }

    @Test
    void vehicleThatMovesOrGoesElsewhereDoesNot() {
        watch.stopReplaced(STOP);
        assertThat(watch.stays(vehicle(STOP, 1), 10_000)).isEmpty();
        assertThat(watch.stays(vehicle(STOP, 1), 13_000)).isEmpty();

        watch.stopReplaced(STOP);
        assertThat(watch.stays(vehicle(STOP - 50, 0), 20_000)).isEmpty();
        assertThat(watch.stays(vehicle(STOP, 0), 30_000)).isEmpty();
    }
}
