package org.sami.boat.server.traffic;

import org.jspecify.annotations.Nullable;

/**
 * The heading of a boat shortly after it has begun to turn: as far as intended, but at most by a limit. Most turns tried in one choice exceed the limit
 * and end in one of two courses, which are computed once because sines are costly.
 */
final class TurnLimit {
    private final double mostRad;
    private CourseVector heading = new CourseVector(0);
    private @Nullable CourseVector toPort; // the heading turned by the limit; null until needed
    private @Nullable CourseVector toStarboard;

    /** A limit in radians. */
    TurnLimit(double mostRad) {
        this.mostRad = mostRad;
    }

    /** Sets the heading from which the boat turns. */
    void setHeading(CourseVector newHeading) {
        heading = newHeading;
        toPort = null;
        toStarboard = null;
    }

    /** Whether a turn in radians, positive to starboard, is within the limit. */
    boolean allows(double turnRad) {
        return Math.abs(turnRad) <= mostRad;
    }

    /**
     * The course after a turn, or after as much of it as the limit allows.
     *
     * @param to the intended course
     * @param turnRad the turn from the heading to it in radians, positive to starboard
     */
    CourseVector after(CourseVector to, double turnRad) {
        if (allows(turnRad)) {
            return to;
        } else if (turnRad < 0) {
            toPort = toPort == null ? new CourseVector(heading.rad() - mostRad) : toPort;
            return toPort;
        }
        toStarboard = toStarboard == null ? new CourseVector(heading.rad() + mostRad) : toStarboard;
        return toStarboard;
    }
}
