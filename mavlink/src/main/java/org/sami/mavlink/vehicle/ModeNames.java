package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.ardupilotmega.CopterMode;
import io.dronefleet.mavlink.ardupilotmega.RoverMode;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;

/** The names of ArduPilot's modes; the numbers of another autopilot's modes mean something else. */
public final class ModeNames {
    private static final int HIGHEST = 100; // ArduPilot's modes end far below

    private static final Map<Integer, String> OF_BOATS =
            names(number -> EnumValue.create(RoverMode.class, number), "ROVER_MODE_");
    private static final Map<Integer, String> OF_COPTERS =
            names(number -> EnumValue.create(CopterMode.class, number), "COPTER_MODE_");

    private ModeNames() {}

    private static Map<Integer, String> names(IntFunction<EnumValue<? extends Enum<?>>> value, String prefix) {
        Map<Integer, String> names = new HashMap<>();
        for (int number = 0; number <= HIGHEST; number++) {
            int each = number;
            Optional.ofNullable(value.apply(number).entry())
                    .ifPresent(mode -> names.put(each, mode.name().substring(prefix.length())));
        }
        return names;
    }

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
        if (autopilot != MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA) {
            return other(customMode);
        }
        return switch (kind) {
            case BOAT, ROVER -> name(OF_BOATS, customMode);
            case COPTER -> name(OF_COPTERS, customMode);
            default -> other(customMode); // its modes are not those of boats or copters
        };
    }

    /** The name of a mode of ArduPilot as pilots write it; {@code mode N} where it is not known. */
    public static String ofArduPilot(VehicleKind kind, long number) {
        return of(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, kind, number);
    }

    private static String name(Map<Integer, String> names, long customMode) {
        String name = names.get((int) customMode);
        return name == null ? other(customMode) : name;
    }

    private static String other(long customMode) {
        return "mode " + customMode;
    }
}
