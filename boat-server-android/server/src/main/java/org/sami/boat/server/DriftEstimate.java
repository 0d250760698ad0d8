package org.sami.boat.server;

import org.sami.boat.server.traffic.CourseVector;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Estimates how current and wind carry a vehicle: the averaged part of its way over ground that its heading does not explain. Only the part across the
 * heading can be seen, so the whole drift is known after a turn.
 */
final class DriftEstimate {
    private static final double AVERAGING_S = 12; // position errors wander: a shorter average follows them
    private static final double MAX_MPS = 2; // faster is a jump of the position receiver

    private double eastMps;
    private double northMps;
    private double lastEastM = Double.NaN;
    private double lastNorthM = Double.NaN;

    /**
     * Takes a position of the vehicle.
     *
     * @param eastM in metres, in any frame that stays the same until {@link #reset}
     */
    void see(double eastM, double northM, CourseVector heading, double seconds) {
        if (seconds > 0 && !Double.isNaN(lastEastM)) {
            double starboardEast = heading.north();
            double starboardNorth = -heading.east();
            double acrossMps = ((eastM - lastEastM) * starboardEast + (northM - lastNorthM) * starboardNorth) / seconds;
            double seenMps = Math.max(-MAX_MPS, Math.min(MAX_MPS, acrossMps));
            double knownMps = eastMps * starboardEast + northMps * starboardNorth;
            double change = (seenMps - knownMps) * Math.min(1, seconds / AVERAGING_S);
            eastMps += change * starboardEast;
            northMps += change * starboardNorth;
        }
        lastEastM = eastM;
        lastNorthM = northM;
    }

    /** The next position is in another frame. */
    void reset() {
        lastEastM = Double.NaN;
        lastNorthM = Double.NaN;
    }

    double speedMps() {
        return PlaneMath.length(eastMps, northMps);
    }

    /** The course straight against the drift, in radians. */
    double againstRad() {
        return StrictMath.atan2(-eastMps, -northMps);
    }

    /** Heading in radians at which a vehicle with this speed through the water makes good a course; the course itself where it is too slow. */
    double headingRad(CourseVector course, double speedMps) {
        double acrossMps = eastMps * course.north() - northMps * course.east(); // to starboard
        double part = Math.max(-0.9, Math.min(0.9, acrossMps / Math.max(speedMps, 1e-3)));
        return course.rad() - StrictMath.asin(part);
    }
}
