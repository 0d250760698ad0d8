package org.sami.boat.hull.position;

/** Where a hull is and how it moves, as far as is known; what is not known is NaN. Immutable. */
public final class Pose {
    /** Nothing is known. */
    public static final Pose UNKNOWN = new Pose(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);

    private final double latDeg;
    private final double lonDeg;
    private final double headingRad;
    private final double speedMps;
    private final double positionErrorM;
    private final double headingErrorRad;

    Pose(
            double latDeg,
            double lonDeg,
            double headingRad,
            double speedMps,
            double positionErrorM,
            double headingErrorRad) {
        this.latDeg = latDeg;
        this.lonDeg = lonDeg;
        this.headingRad = headingRad;
        this.speedMps = speedMps;
        this.positionErrorM = positionErrorM;
        this.headingErrorRad = headingErrorRad;
    }

    /** WGS 84 latitude in degrees. */
    public double latDeg() {
        return latDeg;
    }

    /** WGS 84 longitude in degrees. */
    public double lonDeg() {
        return lonDeg;
    }

    /** Heading in radians, clockwise from true north, -π to π. */
    public double headingRad() {
        return headingRad;
    }

    /** Speed over ground along the heading in m/s; negative is astern. */
    public double speedMps() {
        return speedMps;
    }

    /** Standard deviation of the position along each axis in m. */
    public double positionErrorM() {
        return positionErrorM;
    }

    /** Standard deviation of the heading in radians. */
    public double headingErrorRad() {
        return headingErrorRad;
    }

    /** Whether the position is known. */
    public boolean isLocated() {
        return !Double.isNaN(latDeg);
    }

    /** Whether position and heading are known, so that a boat can be driven. */
    public boolean isComplete() {
        return isLocated() && !Double.isNaN(headingRad);
    }
}
