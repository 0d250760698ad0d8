package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.SysStatus;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What a vehicle says is wrong with it.
 *
 * @param mayArm whether its own checks before arming pass, as far as it has reported
 * @param failsafe whether it carries out a failsafe: it has lost radio, ground station, position or charge
 * @param outsideFence whether it has left its fence
 * @param failing the parts that are switched on and do not work, such as {@code gps} or {@code battery}, and that another vehicle has its id
 */
public record VehicleHealth(boolean mayArm, boolean failsafe, boolean outsideFence, List<String> failing) {
    private static final String PREFIX = "MAV_SYS_STATUS_";
    private static final String SENSOR = "SENSOR_";

    /** What is wrong. */
    public VehicleHealth {
        failing = List.copyOf(failing);
    }

    static VehicleHealth unknown() {
        return new VehicleHealth(false, false, false, List.of());
    }

    VehicleHealth with(SysStatus status) {
        List<String> broken = new ArrayList<>();
        boolean ready = false;
        for (MavSysStatusSensor part : MavSysStatusSensor.values()) {
            boolean well = status.onboardControlSensorsHealth().flagsEnabled(part);
            if (part == MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK) {
                ready = well;
            } else if (status.onboardControlSensorsEnabled().flagsEnabled(part) && !well) {
                broken.add(name(part));
            }
        }
        return new VehicleHealth(ready, failsafe, outsideFence, broken);
    }

    private static String name(MavSysStatusSensor part) {
        String name = part.name().substring(PREFIX.length());
        return (name.startsWith(SENSOR) ? name.substring(SENSOR.length()) : name)
                .toLowerCase(Locale.ROOT)
                .replace('_', ' ');
    }

    VehicleHealth with(String fault) {
        List<String> more = new ArrayList<>(failing);
        more.add(fault);
        return new VehicleHealth(mayArm, failsafe, outsideFence, more);
    }

    VehicleHealth withFailsafe(boolean now) {
        return new VehicleHealth(mayArm, now, outsideFence, failing);
    }

    VehicleHealth withFence(boolean outside) {
        return new VehicleHealth(mayArm, failsafe, outside, failing);
    }
}
