package org.sami.spn.analysis;

import java.util.List;
import java.util.Locale;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Distances, lengths and areas on a sphere of the earth's mean radius: within half a percent of those on the ellipsoid, which is near
 * enough to doubt a location. Altitudes are left alone.
 */
final class Distances {
    private static final double RADIUS_M = 6_371_008.8;

    private Distances() {}

    /** The distance along the ground in metres (haversine formula). */
    static double metres(GeoPoint a, GeoPoint b) {
        double north = Math.sin(Math.toRadians(b.latDeg() - a.latDeg()) / 2);
        double east = Math.sin(Math.toRadians(b.lonDeg() - a.lonDeg()) / 2);
        double h = north * north
                + Math.cos(Math.toRadians(a.latDeg())) * Math.cos(Math.toRadians(b.latDeg())) * east * east;
        return 2 * RADIUS_M * Math.asin(Math.min(1, Math.sqrt(h)));
    }

    /** The length of a way through points, in metres. */
    static double length(List<GeoPoint> way) {
        double metres = 0;
        for (int i = 1; i < way.size(); i++) {
            metres += metres(way.get(i - 1), way.get(i));
        }
        return metres;
    }

    /** The area in square metres, without its holes, on the plane that touches the earth at its first point. */
    static double squareMetres(GeoArea area) {
        double sum = ring(area.outline());
        for (List<GeoPoint> hole : area.holes()) {
            sum -= ring(hole);
        }
        return Math.max(0, sum);
    }

    private static double ring(List<GeoPoint> ring) {
        double perDegree = Math.toRadians(1) * RADIUS_M;
        double eastPerDegree = perDegree * Math.cos(Math.toRadians(ring.get(0).latDeg()));
        double twice = 0;
        for (int i = 0; i < ring.size(); i++) {
            GeoPoint a = ring.get(i);
            GeoPoint b = ring.get((i + 1) % ring.size());
            GeoPoint origin = ring.get(0);
            twice += (a.lonDeg() - origin.lonDeg()) * (b.latDeg() - origin.latDeg())
                    - (b.lonDeg() - origin.lonDeg()) * (a.latDeg() - origin.latDeg());
        }
        return Math.abs(twice) / 2 * perDegree * eastPerDegree;
    }

    /** Whether a point lies inside an area and in none of its holes. */
    static boolean contains(GeoArea area, GeoPoint point) {
        return inRing(area.outline(), point) && area.holes().stream().noneMatch(hole -> inRing(hole, point));
    }

    private static boolean inRing(List<GeoPoint> ring, GeoPoint p) {
        boolean inside = false;
        for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            GeoPoint a = ring.get(i);
            GeoPoint b = ring.get(j);
            boolean straddles = (a.latDeg() > p.latDeg()) != (b.latDeg() > p.latDeg());
            if (straddles
                    && p.lonDeg()
                            < (b.lonDeg() - a.lonDeg()) * (p.latDeg() - a.latDeg()) / (b.latDeg() - a.latDeg())
                                    + a.lonDeg()) {
                inside = !inside;
            }
        }
        return inside;
    }

    /** A distance in words: {@code 850 m}, {@code 12.3 km}, {@code 8,123 km}. */
    static String inWords(double metres) {
        if (metres < 1000) {
            return String.format(Locale.ROOT, "%.0f m", metres);
        }
        return String.format(Locale.ROOT, metres < 100_000 ? "%.1f km" : "%,.0f km", metres / 1000);
    }
}
