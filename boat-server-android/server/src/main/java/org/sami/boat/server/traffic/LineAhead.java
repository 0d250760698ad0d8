package org.sami.boat.server.traffic;

/** The straight line along which a boat is to go, as seen from the boat. */
public final class LineAhead {
    private final double courseRad;
    private final double besideM;
    private final double aheadM;
    private final double behindM;

    /**
     * A line.
     *
     * @param courseRad its course in radians, clockwise from true north
     * @param besideM how far the boat is beside it, to starboard, in metres
     * @param aheadM how far its end is ahead, along it; negative where the boat has come past it
     * @param behindM how far its beginning is behind, along it
     */
    public LineAhead(double courseRad, double besideM, double aheadM, double behindM) {
        this.courseRad = courseRad;
        this.besideM = besideM;
        this.aheadM = aheadM;
        this.behindM = behindM;
    }

    /** The line from the boat straight to a place so far away. */
    public static LineAhead straight(double courseRad, double lengthM) {
        return new LineAhead(courseRad, 0, lengthM, 0);
    }

    /** The course of the line in radians, clockwise from true north. */
    public double courseRad() {
        return courseRad;
    }

    /** How far the end of the line is ahead, in metres. */
    double aheadM() {
        return aheadM;
    }

    /** Metres from the line to the boat, to starboard. */
    public double besideM() {
        return besideM;
    }

    /** What is nearest on the line to a place that lies so many metres farther along it than the boat: that, or one of its ends. */
    double onLineM(double alongM) {
        return Math.min(aheadM, Math.max(-behindM, alongM));
    }
}
