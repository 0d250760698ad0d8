package org.sami.boat.server.traffic;

/** The straight line that a boat follows, relative to the boat. */
public final class LineAhead {
    private final double courseRad;
    private final double offsetM;
    private final double aheadM;
    private final double behindM;

    /**
     * A line.
     *
     * @param courseRad its course in radians, clockwise from true north
     * @param offsetM distance of the boat from the line, in metres; positive to starboard
     * @param aheadM distance along the line to its end, in metres; negative once the boat has passed it
     * @param behindM distance along the line back to its beginning, in metres
     */
    public LineAhead(double courseRad, double offsetM, double aheadM, double behindM) {
        this.courseRad = courseRad;
        this.offsetM = offsetM;
        this.aheadM = aheadM;
        this.behindM = behindM;
    }

    /** The line from the boat to a place at this distance. */
    public static LineAhead straight(double courseRad, double lengthM) {
        return new LineAhead(courseRad, 0, lengthM, 0);
    }

    /** The course of the line in radians, clockwise from true north. */
    public double courseRad() {
        return courseRad;
    }

    /** Distance to the end of the line, in metres. */
    double aheadM() {
        return aheadM;
    }

    /** Distance of the boat from the line in metres; positive to starboard. */
    public double offsetM() {
        return offsetM;
    }

    /** Metres along the line, from the boat, to the point of the line nearest to a place {@code alongM} metres ahead: that, or one of its ends. */
    double onLineM(double alongM) {
        return Math.min(aheadM, Math.max(-behindM, alongM));
    }
}
