package org.sami.boat.mavlink;

import org.sami.boat.link.BoatMode;
import org.sami.mavlink.onboard.OnboardModes;

/** The modes of a boat by ArduPilot's numbers. */
final class BoatModes {
    private BoatModes() {}

    /** Whether a boat has the mode of a number. */
    static boolean isKnown(long number) {
        return number == OnboardModes.MANUAL
                || number == OnboardModes.HOLD
                || number == OnboardModes.LOITER
                || number == OnboardModes.AUTO
                || number == OnboardModes.RETURN
                || number == OnboardModes.GUIDED;
    }

    /** The number by which stations are shown what a boat does. */
    static int shown(BoatMode mode) {
        return switch (mode) {
            case PATH -> OnboardModes.AUTO;
            case HOLD -> OnboardModes.LOITER;
            case TELEOPERATION -> OnboardModes.MANUAL;
            case RETURN -> OnboardModes.RETURN;
            case STOPPED, FLEET_STOP -> OnboardModes.HOLD;
        };
    }
}
