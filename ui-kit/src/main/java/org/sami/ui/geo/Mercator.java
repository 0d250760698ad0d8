package org.sami.ui.geo;

import org.sami.spn.value.GeoPoint;

/**
 * Web Mercator on the unit square: x from 0 at 180° west to 1 at 180° east, y from 0 in the north (85.05°) to 1 in the south. It is the
 * projection of map tiles.
 */
public final class Mercator {
    /** The latitude of the square's upper edge, in degrees. */
    public static final double MOST_LAT_DEG = 85.05112877980659;

    private static final double EQUATOR_M = 40_075_016.68557849;

    private Mercator() {}

    /** The x of a longitude in degrees. */
    public static double x(double lonDeg) {
        return lonDeg / 360 + 0.5;
    }

    /** The y of a latitude in degrees; those beyond the square lie on its edge. */
    public static double y(double latDeg) {
        double bounded = Math.max(-MOST_LAT_DEG, Math.min(MOST_LAT_DEG, latDeg));
        double sine = Math.sin(Math.toRadians(bounded));
        return 0.5 - Math.log((1 + sine) / (1 - sine)) / (4 * Math.PI);
    }

    /** The point at x and y, at altitude zero; x and y outside of the square are moved to its edge. */
    public static GeoPoint point(double x, double y) {
        double lonDeg = (Math.max(0, Math.min(1, x)) - 0.5) * 360;
        double latDeg = Math.toDegrees(Math.atan(Math.sinh(Math.PI * (1 - 2 * Math.max(0, Math.min(1, y))))));
        return GeoPoint.of(latDeg, lonDeg);
    }

    /** How many metres the side of the square is at a latitude. */
    public static double metresPerWorld(double latDeg) {
        return EQUATOR_M * Math.cos(Math.toRadians(latDeg));
    }
}
