package org.sami.mavlink.vehicle;

import java.util.Optional;

/** Which vehicles are commanded from here: boats, ground rovers (whose commands and modes are those of boats) and copters, with ArduPilot. */
public final class CommandedVehicles {
    private static final String ARDUPILOT = "ArduPilot";

    private CommandedVehicles() {}

    /** Why a vehicle is not commanded from here, such as {@code vehicle 5 is a plane, and here only …}; empty for one that is. */
    public static Optional<String> whyNot(VehicleSnapshot vehicle) {
        boolean isOfKind = switch (vehicle.kind()) {
            case BOAT, ROVER, COPTER -> true;
            case PLANE, SUBMARINE, OTHER -> false;
        };
        if (!isOfKind) {
            return Optional.of(
                    "vehicle " + vehicle.id() + " is a " + vehicle.kind().word()
                            + ", and here only surface boats and copters are commanded: give the address or number of one of these");
        }
        return vehicle.autopilot().equals(ARDUPILOT)
                ? Optional.empty()
                : Optional.of("vehicle " + vehicle.id() + " has the autopilot " + vehicle.autopilot()
                        + ", and here only " + ARDUPILOT + "'s vehicles are commanded: their modes are known");
    }
}
