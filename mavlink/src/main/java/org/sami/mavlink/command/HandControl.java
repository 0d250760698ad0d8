package org.sami.mavlink.command;

import io.dronefleet.mavlink.common.ManualControl;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;

/**
 * Sticks by hand (MANUAL_CONTROL), each from -1 to 1. An autopilot takes them in modes that are steered by hand, and forgets them when none come for its
 * {@code RC_OVERRIDE_TIME} (3 s with ArduPilot), so they are sent several times a second.
 *
 * @param forward ahead, negative astern
 * @param right sideways to the right; only of what can move so
 * @param up negative down; only of what flies or dives
 * @param turn to the right, negative to the left
 */
public record HandControl(double forward, double right, double up, double turn) {
    private static final double FULL = 1_000;
    private static final double HALF = 500;

    /** Sticks.
     *
     * @throws IllegalArgumentException if one is not from -1 to 1
     */
    public HandControl {
        check("forward", forward);
        check("right", right);
        check("up", up);
        check("turn", turn);
    }

    private static void check(String stick, double value) {
        if (!(Math.abs(value) <= 1)) {
            throw new IllegalArgumentException(stick + " is from -1 to 1, not " + value);
        }
    }

    /** All sticks in the middle. */
    public static HandControl centred() {
        return new HandControl(0, 0, 0, 0);
    }

    /** The same as a message of the library; ArduPilot's boats take the throttle from {@code z} and the rudder from {@code y}. */
    public Object message(VehicleId vehicle, VehicleKind kind) {
        ManualControl.Builder sticks = ManualControl.builder().target(vehicle.system());
        return kind == VehicleKind.BOAT || kind == VehicleKind.ROVER
                ? sticks.y(whole(turn)).z(whole(forward)).build()
                : sticks.x(whole(forward))
                        .y(whole(right))
                        .z((int) Math.round(HALF + up * HALF))
                        .r(whole(turn))
                        .build();
    }

    private static int whole(double part) {
        return (int) Math.round(part * FULL);
    }
}
