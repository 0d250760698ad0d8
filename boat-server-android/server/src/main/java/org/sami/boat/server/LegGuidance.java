package org.sami.boat.server;

import org.sami.boat.server.traffic.LineAhead;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Guides a vehicle along one leg, the straight line between two waypoints, by line of sight (T. I. Fossen, Handbook of Marine Craft
 * Hydrodynamics and Motion Control, 12.3): the vehicle heads for a point of the line ahead of it, corrects for drift, and slows down before a corner
 * instead of cutting it.
 *
 * <p>Coordinates are metres east and north of the leg's end.
 */
public final class LegGuidance {
    private static final double LEAST_LOOKAHEAD_M = 2;
    // shorter look-aheads oscillate about the line: a hull takes a second to turn
    private static final double LOOKAHEAD_S = 2.5;
    private static final double REACHED_M = 0.4; // closer to the end is close enough
    private static final double LEAST_LEG_M = 0.5; // a shorter leg has no direction

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
    public LegGuidance(double startEastM, double startNorthM, double endMps) {
        lengthM = PlaneMath.length(startEastM, startNorthM);
        boolean directed = lengthM >= LEAST_LEG_M;
        alongEast = directed ? -startEastM / lengthM : 0;
        alongNorth = directed ? -startNorthM / lengthM : 0;
        alongRad = StrictMath.atan2(alongEast, alongNorth);
        this.endMps = endMps;
    }

    /**
     * Whether the leg is done: the vehicle has reached its end, or has passed it within the radius.
     *
     * @param radiusM distance in metres at which a vehicle may pass a waypoint
     */
    public boolean isDone(double eastM, double northM, double radiusM) {
        double distanceM = PlaneMath.length(eastM, northM);
        passed |= remainingM(eastM, northM) <= 0;
        return distanceM <= REACHED_M || (passed && distanceM <= radiusM);
    }

    /** Metres along the leg to its end; negative beyond it. */
    private double remainingM(double eastM, double northM) {
        return -(eastM * alongEast + northM * alongNorth);
    }

    /** The intended speed, or the lower one from which the vehicle can still slow down for the corner. */
    double speedMps(double eastM, double northM, double wantedMps, double driftMps) {
        double atEnd = endMps + driftMps; // a drifting vehicle needs speed to steer
        double leftM = Math.max(0, PlaneMath.length(eastM, northM) - REACHED_M);
        return Math.min(wantedMps, Math.sqrt(atEnd * atEnd + 2 * CornerSpeed.BRAKING_MPS2 * leftM));
    }

    /** Course in radians, clockwise from north, onto the leg and along it; past its end, straight back to the end. */
    public double courseRad(double eastM, double northM, double speedMps) {
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
    public LineAhead line(double eastM, double northM, double straightRad) {
        if (alongEast == 0 && alongNorth == 0) {
            return LineAhead.straight(straightRad, PlaneMath.length(eastM, northM));
        }
        double leftM = remainingM(eastM, northM);
        return new LineAhead(alongRad, offsetM(eastM, northM), leftM, Math.max(0, lengthM - leftM));
    }
}
