package org.sami.boat.link;

/** One waypoint of a list: a position, and the speed of the leg that leads to it; for aircraft its altitude too. Equal by exact value. */
public final class Waypoint {
    private final double latDeg;
    private final double lonDeg;
    private final double speedMps;
    private final double altM;

    /** Makes a waypoint at altitude 0; a value out of its range is an {@link IllegalArgumentException}. */
    public Waypoint(double latDeg, double lonDeg, double speedMps) {
        this(latDeg, lonDeg, speedMps, 0);
    }

    /**
     * Makes a waypoint of an aircraft; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param altM metres above the place where the aircraft took off
     */
    public Waypoint(double latDeg, double lonDeg, double speedMps, double altM) {
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
        this.speedMps = Checks.speed("speed", speedMps);
        this.altM = Checks.altitude(altM);
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

    /** Metres above the place of the take-off; 0 for boats, and for an aircraft on the ground. */
    public double altM() {
        return altM;
    }

    /** The same place at another altitude in metres. */
    public Waypoint at(double otherAltM) {
        return new Waypoint(latDeg, lonDeg, speedMps, otherAltM);
    }

    @Override
    public boolean equals(Object other) {
        if (!(other instanceof Waypoint)) {
            return false;
        }
        Waypoint that = (Waypoint) other;
        return Double.compare(latDeg, that.latDeg) == 0
                && Double.compare(lonDeg, that.lonDeg) == 0
                && Double.compare(speedMps, that.speedMps) == 0
                && Double.compare(altM, that.altM) == 0;
    }

    @Override
    public int hashCode() {
        int hash = (Double.hashCode(latDeg) * 31 + Double.hashCode(lonDeg)) * 31 + Double.hashCode(speedMps);
        return hash * 31 + Double.hashCode(altM);
    }

    @Override
    public String toString() {
        return latDeg + "," + lonDeg + (altM == 0 ? "" : "," + altM + " m") + " at " + speedMps + " m/s";
    }
}
