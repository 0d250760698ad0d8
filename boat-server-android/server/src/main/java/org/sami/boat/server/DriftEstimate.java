package org.sami.boat.server;

import org.sami.boat.server.traffic.Course;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * How current and wind carry a vehicle, as far as it can tell: the part of its way over ground that its heading does not explain,
 * averaged. Only the part across the heading shows, so the whole is known after a turn.
 */
final class DriftEstimate {
    private static final double AVERAGED_S = 12; // receivers of positions wander: shorter averages follow their errors
    private static final double MOST_MPS = 2; // what moves a vehicle faster than that is a jump of its receiver

    private double eastMps;
    private double northMps;
    private double lastEastM = Double.NaN;
    private double lastNorthM = Double.NaN;

    /**
     * The vehicle was seen at a position.
     *
     * @param eastM in metres of any frame that stays the same until {@link #reset}
     */
    void see(double eastM, double northM, Course heading, double seconds) {
        if (seconds > 0 && !Double.isNaN(lastEastM)) {
            double starboardEast = heading.north();
            double starboardNorth = -heading.east();
            double acrossMps = ((eastM - lastEastM) * starboardEast + (northM - lastNorthM) * starboardNorth) / seconds;
            double seenMps = Math.max(-MOST_MPS, Math.min(MOST_MPS, acrossMps));
            double knownMps = eastMps * starboardEast + northMps * starboardNorth;
            double change = (seenMps - knownMps) * Math.min(1, seconds / AVERAGED_S);
            eastMps += change * starboardEast;
            northMps += change * starboardNorth;
        }
        lastEastM = eastM;
        lastNorthM = northM;
    }

    /** The next position is one of another frame. */
    void reset() {
        lastEastM = Double.NaN;
        lastNorthM = Double.NaN;
    }

    double speedMps() {
        return PlaneMath.length(eastMps, northMps);
    }

    /** The course in radians straight against it. */
    double againstRad() {
        return StrictMath.atan2(-eastMps, -northMps);
    }

    /** Heading in radians at which a vehicle of that speed through the water makes good a course; the course where it is too slow. */
    double headingRad(Course course, double speedMps) {
        double acrossMps = eastMps * course.north() - northMps * course.east(); // to starboard
        double part = Math.max(-0.9, Math.min(0.9, acrossMps / Math.max(speedMps, 1e-3)));
        return course.rad() - StrictMath.asin(part);
    }
}
