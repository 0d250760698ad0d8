package org.sami.boat.server.traffic;

/**
 * Where a boat may head a moment after it has begun to turn: as far as it is to turn, but at most so far. Most turns that are tried in one choice are
 * farther than that and end in one of two courses, which are computed once, since sines are dear.
 */
final class TurnLimit {
    private final double mostRad;
    private Course heading = new Course(0);
    private Course toPort; // of the heading, as far as it may; null until it is wanted
    private Course toStarboard;

    /** At most so far, in radians. */
    TurnLimit(double mostRad) {
        this.mostRad = mostRad;
    }

    /** From now on it turns from here. */
    void setHeading(Course newHeading) {
        heading = newHeading;
        toPort = null;
        toStarboard = null;
    }

    /** Whether a turn in radians, positive to starboard, is not cut short. */
    boolean allows(double turnRad) {
        return Math.abs(turnRad) <= mostRad;
    }

    /**
     * The course after a turn, or after as much of it as is possible.
     *
     * @param to where it turns to
     * @param turnRad from its heading to there in radians, positive to starboard
     */
    Course after(Course to, double turnRad) {
        if (allows(turnRad)) {
            return to;
        } else if (turnRad < 0) {
            toPort = toPort == null ? new Course(heading.rad() - mostRad) : toPort;
            return toPort;
        }
        toStarboard = toStarboard == null ? new Course(heading.rad() + mostRad) : toStarboard;
        return toStarboard;
    }
}
