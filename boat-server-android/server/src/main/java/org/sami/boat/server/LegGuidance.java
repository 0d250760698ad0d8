package org.sami.boat.server;

import org.sami.boat.server.traffic.LineAhead;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Guides a vehicle along one leg, the straight line between two waypoints, in line of sight (T. I. Fossen, Handbook of Marine Craft
 * Hydrodynamics and Motion Control, 12.3): it heads for a point of the line that lies ahead of it, against the drift that it sees,
 * and slows down before a corner, so that it turns there and not before.
 *
 * <p>Coordinates are metres east and north of the leg's end.
 */
final class LegGuidance {
    private static final double LEAST_LOOKAHEAD_M = 2;
    // shorter ones swing about the line, as a hull takes a second to turn
    private static final double LOOKAHEAD_S = 2.5;
    private static final double REACHED_M = 0.4; // this near the end nothing is gained by going on
    private static final double LEAST_LEG_M = 0.5; // shorter ones have no direction to keep to

    private final double alongEast; // unit vector of the leg; zero = straight to its end from wherever it is
    private final double alongNorth;
    private final double alongRad;
    private final double lengthM;
    private final double endMps;
    private boolean passed;

    /**
     * A leg.
     *
     * @param startEastM where it begins
     * @param startNorthM where it begins
     * @param endMps how fast the vehicle may be at its end
     */
    LegGuidance(double startEastM, double startNorthM, double endMps) {
        lengthM = PlaneMath.length(startEastM, startNorthM);
        boolean directed = lengthM >= LEAST_LEG_M;
        alongEast = directed ? -startEastM / lengthM : 0;
        alongNorth = directed ? -startNorthM / lengthM : 0;
        alongRad = StrictMath.atan2(alongEast, alongNorth);
        this.endMps = endMps;
    }

    /**
     * Whether the leg is done: its end is as near as makes no difference, or the vehicle has come past it within the radius.
     *
     * @param radiusM how far beside a waypoint a vehicle may pass it
     */
    boolean isDone(double eastM, double northM, double radiusM) {
        double distanceM = PlaneMath.length(eastM, northM);
        passed |= remainingM(eastM, northM) <= 0;
        return distanceM <= REACHED_M || (passed && distanceM <= radiusM);
    }

    /** Metres along the leg to its end; negative beyond it. */
    private double remainingM(double eastM, double northM) {
        return -(eastM * alongEast + northM * alongNorth);
    }

    /** Speed at which the vehicle can still slow down for the corner; of the wanted speed at most. */
    double speedMps(double eastM, double northM, double wantedMps, double driftMps) {
        double atEnd = endMps + driftMps; // what drifts needs way on to be steered
        double leftM = Math.max(0, PlaneMath.length(eastM, northM) - REACHED_M);
        return Math.min(wantedMps, Math.sqrt(atEnd * atEnd + 2 * CornerSpeed.BRAKING_MPS2 * leftM));
    }

    /** Course in radians, clockwise from north, that leads onto the leg and along it; once past its end, straight back to that. */
    double courseRad(double eastM, double northM, double speedMps) {
        if (passed || (alongEast == 0 && alongNorth == 0)) {
            return StrictMath.atan2(-eastM, -northM);
        }
        double lookaheadM = Math.max(LEAST_LOOKAHEAD_M, LOOKAHEAD_S * speedMps);
        return alongRad - StrictMath.atan2(offsetM(eastM, northM), lookaheadM);
    }

    /** Metres to starboard of the line; zero where there is none. */
    double offsetM(double eastM, double northM) {
        return eastM * alongNorth - northM * alongEast;
    }

    /**
     * The line as seen from the vehicle.
     *
     * @param straightRad the course straight to its end, for a leg that has no line
     */
    LineAhead line(double eastM, double northM, double straightRad) {
        if (alongEast == 0 && alongNorth == 0) {
            return LineAhead.straight(straightRad, PlaneMath.length(eastM, northM));
        }
        double leftM = remainingM(eastM, northM);
        return new LineAhead(alongRad, offsetM(eastM, northM), leftM, Math.max(0, lengthM - leftM));
    }
}
