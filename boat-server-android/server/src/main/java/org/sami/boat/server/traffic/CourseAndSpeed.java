package org.sami.boat.server.traffic;

/** Course and speed of a boat. */
public final class CourseAndSpeed {
    private final CourseVector course;
    private final double speedMps;

    /**
     * A course and a speed.
     *
     * @param courseRad radians clockwise from true north
     * @param speedMps m/s along it; negative is astern
     */
    public CourseAndSpeed(double courseRad, double speedMps) {
        this.course = new CourseVector(courseRad);
        this.speedMps = speedMps;
    }

    /** The course. */
    public CourseVector course() {
        return course;
    }

    /** The course in radians, clockwise from true north. */
    public double courseRad() {
        return course.rad();
    }

    /** The speed in m/s along the course; negative is astern. */
    public double speedMps() {
        return speedMps;
    }
}
