package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.ardupilotmega.CopterMode;
import io.dronefleet.mavlink.ardupilotmega.RoverMode;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Optional;

/** The names of ArduPilot's modes; the numbers of another autopilot's modes mean something else. */
final class ModeNames {
    private static final long HIGHEST = 100; // ArduPilot's modes end far below

    private ModeNames() {}

    /** The number of a mode by its name, in any case; empty where the vehicle has none of this name. */
    static Optional<Long> number(MavAutopilot autopilot, VehicleKind kind, String name) {
        for (long number = 0; number <= HIGHEST; number++) {
            if (of(autopilot, kind, number).equalsIgnoreCase(name)) {
                return Optional.of(number);
            }
        }
        return Optional.empty();
    }

    /** The name of a mode as pilots write it, such as {@code AUTO}; {@code mode N} where it is not known. */
    static String of(MavAutopilot autopilot, VehicleKind kind, long customMode) {
        int number = (int) customMode;
        if (autopilot == MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA) {
            switch (kind) {
                case BOAT, ROVER -> {
                    RoverMode mode = EnumValue.create(RoverMode.class, number).entry();
                    if (mode != null) {
                        return mode.name().substring("ROVER_MODE_".length());
                    }
                }
                case COPTER -> {
                    CopterMode mode = EnumValue.create(CopterMode.class, number).entry();
                    if (mode != null) {
                        return mode.name().substring("COPTER_MODE_".length());
                    }
                }
                default -> {
                    // its modes are not those of boats or copters
                }
            }
        }
        return "mode " + customMode;
    }
}
