package org.sami.boat.hull.board;

import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;

/**
 * Makes the commands to the board from the efforts of a port and a starboard motor, by the settings of the hull. A hull with a rudder gets their mean as thrust
 * and half their difference as rudder; its thrust is never negative, and while it steers it has a little, as the rudder of a hull at rest turns nothing.
 */
final class MotorMixer {
    private MotorMixer() {}

    static MotorEfforts mix(HullSettings hull, double port, double starboard) {
        if (!(Math.abs(port) <= Double.MAX_VALUE && Math.abs(starboard) <= Double.MAX_VALUE)) {
            return MotorEfforts.NONE; // no number is no effort
        }
        if (port == 0 && starboard == 0) {
            return MotorEfforts.NONE;
        }
        double left = clip(port);
        double right = clip(starboard);
        double thrust = (left + right) / 2;
        double turn = clip((left - right) / 2 + hull.trim());
        return hull.kind() == HullKind.RUDDER ? rudder(hull, thrust, turn) : differential(hull, thrust, turn);
    }

    private static MotorEfforts differential(HullSettings hull, double thrust, double turn) {
        double left = signed(hull.leftReversed(), clip(thrust + turn) * hull.safeMaximum());
        double right = signed(hull.rightReversed(), clip(thrust - turn) * hull.safeMaximum());
        return hull.sidesSwapped() ? new MotorEfforts(right, left) : new MotorEfforts(left, right);
    }

    private static MotorEfforts rudder(HullSettings hull, double thrust, double turn) {
        double ahead = Math.max(thrust, hull.steeringThrust() * Math.abs(turn - hull.trim()));
        double motor = signed(hull.leftReversed(), Math.max(0, ahead) * hull.safeMaximum());
        return new MotorEfforts(motor, signed(hull.rudderReversed(), turn));
    }

    private static double signed(boolean reversed, double effort) {
        return reversed ? 0 - effort : effort;
    }

    private static double clip(double effort) {
        return Math.max(-1, Math.min(1, effort));
    }
}
