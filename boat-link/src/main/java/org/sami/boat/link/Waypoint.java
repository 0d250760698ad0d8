package org.sami.boat.link;

/** One waypoint of a list: a position, and the speed of the leg that leads to it. Equal by exact value. */
public final class Waypoint {
    private final double latDeg;
    private final double lonDeg;
    private final double speedMps;

    /** Makes a waypoint; a value out of its range is an {@link IllegalArgumentException}. */
    public Waypoint(double latDeg, double lonDeg, double speedMps) {
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
        this.speedMps = Checks.speed("speed", speedMps);
    }

    /** WGS 84 latitude in degrees. */
    public double latDeg() {
        return latDeg;
    }

    /** WGS 84 longitude in degrees. */
    public double lonDeg() {
        return lonDeg;
    }

    /** Speed of the leg to this waypoint in m/s. */
    public double speedMps() {
        return speedMps;
    }

    @Override
    public boolean equals(Object other) {
        if (!(other instanceof Waypoint)) {
            return false;
        }
        Waypoint that = (Waypoint) other;
        return Double.compare(latDeg, that.latDeg) == 0
                && Double.compare(lonDeg, that.lonDeg) == 0
                && Double.compare(speedMps, that.speedMps) == 0;
    }

    @Override
    public int hashCode() {
        return (Double.hashCode(latDeg) * 31 + Double.hashCode(lonDeg)) * 31 + Double.hashCode(speedMps);
    }

    @Override
    public String toString() {
        return latDeg + "," + lonDeg + " at " + speedMps + " m/s";
    }
}
