package org.sami.boat.hull.position;

/** One position of a GPS receiver. Any number may be NaN or out of range: the position filter refuses what makes no sense. Immutable. */
public final class GpsFix {
    private final double latDeg;
    private final double lonDeg;
    private final double accuracyM;
    private final double speedMps;
    private final double courseRad;

    /**
     * A position with speed and course.
     *
     * @param latDeg WGS 84 latitude in degrees
     * @param lonDeg WGS 84 longitude in degrees
     * @param accuracyM horizontal error by the receiver's own account, one standard deviation, in m; NaN if it gives none
     * @param speedMps speed over ground; NaN if it gives none
     * @param courseRad course over ground, clockwise from true north; NaN if it gives none
     */
    public GpsFix(double latDeg, double lonDeg, double accuracyM, double speedMps, double courseRad) {
        this.latDeg = latDeg;
        this.lonDeg = lonDeg;
        this.accuracyM = accuracyM;
        this.speedMps = speedMps;
        this.courseRad = courseRad;
    }

    /** A position alone. */
    public static GpsFix at(double latDeg, double lonDeg) {
        return new GpsFix(latDeg, lonDeg, Double.NaN, Double.NaN, Double.NaN);
    }

    /** WGS 84 latitude in degrees. */
    public double latDeg() {
        return latDeg;
    }

    /** WGS 84 longitude in degrees. */
    public double lonDeg() {
        return lonDeg;
    }

    /** Standard deviation of the position in m by the receiver's account; NaN if unknown. */
    public double accuracyM() {
        return accuracyM;
    }

    /** Speed over ground in m/s; NaN if unknown. */
    public double speedMps() {
        return speedMps;
    }

    /** Course over ground in radians, clockwise from true north; NaN if unknown. */
    public double courseRad() {
        return courseRad;
    }
}
