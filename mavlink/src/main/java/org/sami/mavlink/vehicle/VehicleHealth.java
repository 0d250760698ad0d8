package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * What a vehicle says is wrong with it.
 *
 * @param mayArm whether its own checks before arming pass, as far as it has reported
 * @param failsafe whether it carries out a failsafe: it has lost radio, ground station, position or charge
 * @param outsideFence whether it has left its fence
 * @param fenceOn whether the fence that it holds is in force, whatever its parameters say; empty where it does not say that it holds one
 * @param failing the parts that are switched on and do not work, such as {@code gps} or {@code battery}, and that another vehicle has its id
 */
public record VehicleHealth(
        boolean mayArm, boolean failsafe, boolean outsideFence, Optional<Boolean> fenceOn, List<String> failing) {
    private static final String ANOTHER = "another vehicle has the id ";
    private static final String TOO = " too";
    private static final String PREFIX = "MAV_SYS_STATUS_";
    private static final String SENSOR = "SENSOR_";
    private static final int CHECKS = bit(MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK);
    private static final int FENCE = bit(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE);
    private static final List<Part> PARTS = Arrays.stream(MavSysStatusSensor.values())
            .map(part -> new Part(bit(part), name(part)))
            .filter(part -> part.bit != CHECKS)
            .toList();

    /** A part that may fail. */
    private record Part(int bit, String name) {}

    private static int bit(MavSysStatusSensor part) {
        return EnumValue.of(part).value();
    }

    /** What is wrong. */
    public VehicleHealth {
        failing = List.copyOf(failing);
    }

    static VehicleHealth unknown() {
        return new VehicleHealth(false, false, false, Optional.empty(), List.of());
    }

    VehicleHealth with(SysStatus status) {
        int working = status.onboardControlSensorsHealth().value();
        int enabled = status.onboardControlSensorsEnabled().value();
        int broken = enabled & ~working;
        boolean hasFence = (status.onboardControlSensorsPresent().value() & FENCE) != 0;
        return new VehicleHealth(
                (working & CHECKS) != 0,
                failsafe,
                outsideFence,
                hasFence ? Optional.of((enabled & FENCE) != 0) : Optional.empty(),
                PARTS.stream()
                        .filter(part -> (broken & part.bit) != 0)
                        .map(Part::name)
                        .toList());
    }

    private static String name(MavSysStatusSensor part) {
        String name = part.name().substring(PREFIX.length());
        return (name.startsWith(SENSOR) ? name.substring(SENSOR.length()) : name)
                .toLowerCase(Locale.ROOT)
                .replace('_', ' ');
    }

    /** Whether two vehicles on one link have its id, so that which of both has sent a message cannot be told. */
    public boolean sharesId() {
        return failing.stream().anyMatch(fault -> fault.startsWith(ANOTHER) && fault.endsWith(TOO));
    }

    VehicleHealth withSharedId(VehicleId id) {
        return with(ANOTHER + id + TOO);
    }

    VehicleHealth withOther(VehicleId id, MavlinkAddress link) {
        return with(ANOTHER + id + " on " + link);
    }

    private VehicleHealth with(String fault) {
        List<String> more = new ArrayList<>(failing);
        more.add(fault);
        return new VehicleHealth(mayArm, failsafe, outsideFence, fenceOn, more);
    }

    VehicleHealth withFailsafe(boolean now) {
        return new VehicleHealth(mayArm, now, outsideFence, fenceOn, failing);
    }

    VehicleHealth withFence(boolean outside) {
        return new VehicleHealth(mayArm, failsafe, outside, fenceOn, failing);
    }
}
