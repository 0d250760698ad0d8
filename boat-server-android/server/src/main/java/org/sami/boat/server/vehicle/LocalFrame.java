package org.sami.boat.server.vehicle;

import org.sami.boat.link.Waypoint;

/**
 * A plane in metres, east and north of an origin, tangent to the WGS 84 ellipsoid there.
 *
 * <p>Series of second order in the distance with the ellipsoid's two radii of curvature. Within 2 km of the origin it
 * agrees with the geodesic to a few millimetres, and there and back to less than a micrometre; beyond 20 km it is not
 * meant to be used. Longitudes may cross the date line; the poles are out of reach.
 */
public final class LocalFrame {
    private static final double EQUATOR_RADIUS_M = 6378137.0;
    private static final double ECCENTRICITY_SQUARED = 6.69437999014e-3;
    private static final int ITERATIONS = 5;

    private final double originLatDeg;
    private final double originLonDeg;
    private final double meridianM; // metres of north per radian of latitude
    private final double parallelM; // metres of east per radian of longitude
    private final double shrink; // how fast a parallel shortens towards the pole
    private final double bend; // how far a parallel lies north of the tangent
    private final double stretch; // how fast a meridian's radius grows towards the pole

    /** A plane that touches the ellipsoid at a position of at most 85 degrees of latitude. */
    public LocalFrame(double originLatDeg, double originLonDeg) {
        if (!(Math.abs(originLatDeg) <= 85 && Math.abs(originLonDeg) <= 180)) {
            throw new IllegalArgumentException("no plane at " + originLatDeg + ", " + originLonDeg);
        }
        this.originLatDeg = originLatDeg;
        this.originLonDeg = originLonDeg;
        double sin = StrictMath.sin(Math.toRadians(originLatDeg));
        double cos = StrictMath.cos(Math.toRadians(originLatDeg));
        double flat = 1 - ECCENTRICITY_SQUARED * sin * sin;
        double normalM = EQUATOR_RADIUS_M / Math.sqrt(flat);
        meridianM = normalM * (1 - ECCENTRICITY_SQUARED) / flat;
        parallelM = normalM * cos;
        shrink = meridianM * sin;
        bend = 0.5 * normalM * sin * cos;
        stretch = 1.5 * meridianM * ECCENTRICITY_SQUARED * sin * cos / flat;
    }

    /** Latitude of the origin in degrees. */
    public double originLatDeg() {
        return originLatDeg;
    }

    /** Longitude of the origin in degrees. */
    public double originLonDeg() {
        return originLonDeg;
    }

    /** The origin as a waypoint to which a leg of that speed leads. */
    public Waypoint origin(double speedMps) {
        return new Waypoint(originLatDeg, originLonDeg, speedMps);
    }

    /** Metres east of the origin. */
    public double eastM(double latDeg, double lonDeg) {
        return (parallelM - shrink * latRad(latDeg)) * lonRad(lonDeg);
    }

    /** Metres north of the origin. */
    public double northM(double latDeg, double lonDeg) {
        double lat = latRad(latDeg);
        double lon = lonRad(lonDeg);
        return meridianM * lat + bend * lon * lon + stretch * lat * lat;
    }

    /** Latitude in degrees of a place on the plane. */
    public double latDeg(double eastM, double northM) {
        double lat = northM / meridianM;
        double before = Double.NaN;
        for (int i = 0; i < ITERATIONS && lat != before; i++) { // where it stays, further steps change nothing
            before = lat;
            double lon = eastM / (parallelM - shrink * lat);
            lat = (northM - bend * lon * lon - stretch * lat * lat) / meridianM;
        }
        return originLatDeg + Math.toDegrees(lat);
    }

    /** Longitude in degrees, -180 to 180, of a place on the plane. */
    public double lonDeg(double eastM, double northM) {
        return lonDegOn(latDeg(eastM, northM), eastM);
    }

    /** Longitude in degrees, -180 to 180, of a place on the plane whose latitude is known. */
    public double lonDegOn(double latDeg, double eastM) {
        double lat = Math.toRadians(latDeg - originLatDeg);
        return wrapped(originLonDeg + Math.toDegrees(eastM / (parallelM - shrink * lat)));
    }

    /** Metres between a position and the origin. */
    public double distanceM(double latDeg, double lonDeg) {
        return PlaneMath.length(eastM(latDeg, lonDeg), northM(latDeg, lonDeg));
    }

    private double latRad(double latDeg) {
        return Math.toRadians(latDeg - originLatDeg);
    }

    private double lonRad(double lonDeg) {
        return Math.toRadians(wrapped(lonDeg - originLonDeg));
    }

    private static double wrapped(double lonDeg) {
        if (lonDeg > 180) {
            return lonDeg - 360;
        }
        return lonDeg < -180 ? lonDeg + 360 : lonDeg;
    }
}
