package org.sami.mavlink.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.ardupilotmega.WaterDepth;
import io.dronefleet.mavlink.common.CameraTrackingGeoStatus;
import io.dronefleet.mavlink.common.CameraTrackingStatusFlags;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;

/** What cameras and sounders of a vehicle say, and what that says of it. */
class TrackedTargetsTest {
    private static final MavlinkAddress CABLE = AddressText.parse("mavlink:udp:14550");
    private static final VehicleId ONE = new VehicleId(1, 1);
    private static final int CAMERA = 100;

    private final VehicleTable table = new VehicleTable();

    @BeforeEach
    void hearTwoVehicles() {
        for (int system = 1; system <= 2; system++) {
            heard(
                    system,
                    1,
                    Heartbeat.builder()
                            .type(MavType.MAV_TYPE_QUADROTOR)
                            .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                            .baseMode(MavModeFlag.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED)
                            .systemStatus(MavState.MAV_STATE_STANDBY)
                            .build());
        }
    }

    private List<VehicleEvent> heard(int system, int component, Object payload) {
        return table.heard(new MessageOrigin(CABLE, system, component, 0), payload, 1_000);
    }

    private static CameraTrackingGeoStatus target(CameraTrackingStatusFlags status, int lat, int lon) {
        return CameraTrackingGeoStatus.builder()
                .trackingStatus(status)
                .lat(lat)
                .lon(lon)
                .build();
    }

    @Test
    void whatACameraFollowsIsToldOfTheVehicleThatCarriesIt() {
        CameraTrackingGeoStatus target =
                target(CameraTrackingStatusFlags.CAMERA_TRACKING_STATUS_FLAGS_ACTIVE, 457_000_000, 107_200_000);

        assertThat(heard(1, CAMERA, target))
                .containsExactly(new VehicleEvent.TargetTracked(ONE, 457_000_000 * 1e-7, 107_200_000 * 1e-7));
        assertThat(heard(1, 1, target))
                .containsExactly(new VehicleEvent.TargetTracked(ONE, 457_000_000 * 1e-7, 107_200_000 * 1e-7));
        assertThat(heard(7, CAMERA, target)).isEmpty();
        assertThat(table.ids()).containsExactly(ONE, new VehicleId(2, 1));
    }

    @Test
    void cameraThatFollowsNothingOrDoesNotKnowWhereSaysNothing() {
        assertThat(heard(
                        1,
                        CAMERA,
                        target(CameraTrackingStatusFlags.CAMERA_TRACKING_STATUS_FLAGS_IDLE, 457_000_000, 107_200_000)))
                .isEmpty();
        assertThat(heard(1, CAMERA, target(CameraTrackingStatusFlags.CAMERA_TRACKING_STATUS_FLAGS_ACTIVE, 0, 0)))
                .isEmpty();
        assertThat(heard(
                        1,
                        CAMERA,
                        target(CameraTrackingStatusFlags.CAMERA_TRACKING_STATUS_FLAGS_ACTIVE, 910_000_000, 5)))
                .isEmpty();
    }

    @Test
    void sounderWithoutAThermometerMeasuresNoTemperature() {
        assertThat(heard(1, 1, water(0)))
                .containsExactly(new VehicleEvent.Measured(ONE, new VehicleReading("depth", 8, "m")));
        assertThat(heard(1, 1, water(12.5f)))
                .containsExactly(
                        new VehicleEvent.Measured(ONE, new VehicleReading("depth", 8, "m")),
                        new VehicleEvent.Measured(ONE, new VehicleReading("temperature", 12.5, "°C")));
    }

    private static WaterDepth water(float temperature) {
        return WaterDepth.builder()
                .healthy(1)
                .distance(8)
                .temperature(temperature)
                .build();
    }
}
