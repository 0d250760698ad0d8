package org.sami.crw.service;

import org.sami.spn.value.GeoPoint;

/**
 * A plane that touches the WGS-84 ellipsoid at an origin: x to the east, y to the north, in metres. Coordinates are the
 * angles times the two radii of curvature at the origin's latitude. For comparing many distances within one operating
 * area: over 2 km they are right to a metre even at 60 degrees, at a hundredth of a geodesic's cost. What is reported is
 * measured by {@link Geodesy}.
 */
public final class LocalPlane {
    private static final double EQUATOR_RADIUS_M = 6_378_137.0;
    private static final double FLATTENING = 1 / 298.257223563;

    private final GeoPoint origin;
    private final double metresPerLonDeg;
    private final double metresPerLatDeg;

    /** A plane that touches at a point. */
    public LocalPlane(GeoPoint origin) {
        this.origin = origin;
        double e2 = FLATTENING * (2 - FLATTENING);
        double sin = Math.sin(Math.toRadians(origin.latDeg()));
        double w2 = 1 - e2 * sin * sin;
        double primeVerticalM = EQUATOR_RADIUS_M / Math.sqrt(w2);
        double meridianM = primeVerticalM * (1 - e2) / w2;
        metresPerLonDeg = Math.toRadians(primeVerticalM * Math.cos(Math.toRadians(origin.latDeg())));
        metresPerLatDeg = Math.toRadians(meridianM);
    }

    /** Metres to the east of the origin, the shorter way round the earth. */
    public double x(GeoPoint point) {
        return Math.IEEEremainder(point.lonDeg() - origin.lonDeg(), 360) * metresPerLonDeg;
    }

    /** Metres to the north of the origin. */
    public double y(GeoPoint point) {
        return (point.latDeg() - origin.latDeg()) * metresPerLatDeg;
    }

    /** The point of the surface at plane coordinates, in metres; at altitude zero. */
    public GeoPoint point(double x, double y) {
        double lonDeg = Math.IEEEremainder(origin.lonDeg() + x / metresPerLonDeg, 360);
        return GeoPoint.of(origin.latDeg() + y / metresPerLatDeg, lonDeg);
    }
}
