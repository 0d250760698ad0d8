package org.sami.crw.service;

import org.sami.spn.value.GeoPoint;

/**
 * A plane that touches the WGS-84 ellipsoid at an origin: x to the east, y to the north, in metres. Coordinates are angles times the two radii of
 * curvature at the origin's latitude. It compares many distances within one operating area: over 2 km they are accurate to a metre even at 60
 * degrees, at a hundredth of the cost of a geodesic. {@link Geodesy} measures distances that are reported.
 *
 * <p>Within two degrees of a pole the plane touches at the pole, turned so that north is up at the origin: lengths along a parallel are accurate to
 * one part in 5,000.
 */
public final class LocalPlane {
    private static final double EQUATOR_RADIUS_M = 6_378_137.0;
    private static final double FLATTENING = 1 / 298.257223563;

    /** From this latitude on the plane touches at the pole. */
    private static final double POLAR_DEG = 88;

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
        double turnDeg = point.lonDeg() - origin.lonDeg();
        double eastDeg = Math.abs(turnDeg) <= 180 ? turnDeg : Math.IEEEremainder(turnDeg, 360);
        return isPolar() ? poleM(point.latDeg()) * Math.sin(Math.toRadians(eastDeg)) : eastDeg * metresPerLonDeg;
    }

    /** Metres to the north of the origin. */
    public double y(GeoPoint point) {
        if (!isPolar()) {
            return (point.latDeg() - origin.latDeg()) * metresPerLatDeg;
        }
        double alongM = poleM(point.latDeg()) * Math.cos(Math.toRadians(point.lonDeg() - origin.lonDeg()));
        return Math.signum(origin.latDeg()) * (poleM(origin.latDeg()) - alongM);
    }

    /** Metres between two points, in a straight line on the plane. */
    public double distanceM(GeoPoint one, GeoPoint other) {
        double byX = x(other) - x(one);
        double byY = y(other) - y(one);
        return Math.sqrt(byX * byX + byY * byY); // not hypot, which is ten times as dear
    }

    /** Metres between a point and the origin, likewise. */
    public double distanceM(GeoPoint point) {
        double x = x(point);
        double y = y(point);
        return Math.sqrt(x * x + y * y);
    }

    private boolean isPolar() {
        return Math.abs(origin.latDeg()) > POLAR_DEG;
    }

    /** Distance of a parallel from the pole that is near, in metres. */
    private double poleM(double latDeg) {
        return (90 - Math.signum(origin.latDeg()) * latDeg) * metresPerLatDeg;
    }

    /** The point of the surface at plane coordinates, in metres; at altitude zero. */
    public GeoPoint point(double x, double y) {
        if (isPolar()) {
            double sign = Math.signum(origin.latDeg());
            double alongM = poleM(origin.latDeg()) - sign * y;
            double lonDeg = Math.IEEEremainder(origin.lonDeg() + Math.toDegrees(Math.atan2(x, alongM)), 360);
            return GeoPoint.of(sign * (90 - Math.hypot(x, alongM) / metresPerLatDeg), lonDeg);
        }
        double lonDeg = Math.IEEEremainder(origin.lonDeg() + x / metresPerLonDeg, 360);
        return GeoPoint.of(origin.latDeg() + y / metresPerLatDeg, lonDeg);
    }
}
