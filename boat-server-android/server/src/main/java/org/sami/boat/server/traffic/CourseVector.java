package org.sami.boat.server.traffic;

import org.sami.boat.server.vehicle.PlaneMath;

/** A course with its unit vector: sines are costly, and one choice needs some of them dozens of times. */
public final class CourseVector {
    private final double rad;
    private final double east;
    private final double north;

    /** A course in radians, clockwise from true north. */
    public CourseVector(double rad) {
        this(rad, StrictMath.sin(rad), StrictMath.cos(rad));
    }

    private CourseVector(double rad, double east, double north) {
        this.rad = rad;
        this.east = east;
        this.north = north;
    }

    /** This course, turned to starboard by another one's angle from north. */
    CourseVector turned(CourseVector by) {
        return new CourseVector(rad + by.rad, east * by.north + north * by.east, north * by.north - east * by.east);
    }

    public double rad() {
        return rad;
    }

    /** East part of the unit vector along it. */
    public double east() {
        return east;
    }

    /** North part of that vector. */
    public double north() {
        return north;
    }

    /** Cosine of the turn from another course to this one: the share of a way along this one that leads along the other. */
    double along(CourseVector other) {
        return east * other.east + north * other.north;
    }

    /** Sine of that turn: the share that leads to starboard of the other. */
    double across(CourseVector other) {
        return east * other.north - north * other.east;
    }

    /** The turn from another course to this one, in -π to π. */
    double turnFrom(double otherRad) {
        return PlaneMath.sameTurn(rad - otherRad);
    }
}
