package org.sami.ui.geo;

import java.util.List;
import java.util.Locale;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;
import net.sf.geographiclib.PolygonArea;
import org.sami.spn.value.GeoPoint;

/** Lengths, directions and areas on the WGS-84 ellipsoid, and how they are written. Altitudes are left alone. */
public final class GeoMeasure {
    private static final double KILOMETRE = 1000;
    private static final double HECTARE = 10_000;

    private GeoMeasure() {}

    /** The distance along the ground, in metres. */
    public static double metres(GeoPoint from, GeoPoint to) {
        return inverse(from, to, GeodesicMask.DISTANCE).s12;
    }

    /** The direction in which one leaves a point for another, in degrees clockwise from true north, 0 to 360. */
    public static double bearingDeg(GeoPoint from, GeoPoint to) {
        double azimuth = inverse(from, to, GeodesicMask.AZIMUTH).azi1;
        return azimuth < 0 ? azimuth + 360 : azimuth;
    }

    private static GeodesicData inverse(GeoPoint from, GeoPoint to, int mask) {
        return Geodesic.WGS84.Inverse(from.latDeg(), from.lonDeg(), to.latDeg(), to.lonDeg(), mask);
    }

    /** The length of a way through points, in metres. */
    public static double length(List<GeoPoint> way) {
        double metres = 0;
        for (int i = 1; i < way.size(); i++) {
            metres += metres(way.get(i - 1), way.get(i));
        }
        return metres;
    }

    /** The area inside of an outline, in square metres. */
    public static double squareMetres(List<GeoPoint> outline) {
        PolygonArea polygon = new PolygonArea(Geodesic.WGS84, false);
        outline.forEach(point -> polygon.AddPoint(point.latDeg(), point.lonDeg()));
        return Math.abs(polygon.Compute(false, true).area);
    }

    /** A length for people: "0.8 m", "12 m", "1.25 km". */
    public static String length(double metres) {
        if (metres >= KILOMETRE) {
            return String.format(Locale.ROOT, "%.2f km", metres / KILOMETRE);
        }
        return String.format(Locale.ROOT, metres < 10 ? "%.1f m" : "%.0f m", metres);
    }

    /** An area for people: "250 m²", "1.25 ha", "3.20 km²". */
    public static String area(double squareMetres) {
        if (squareMetres >= KILOMETRE * KILOMETRE) {
            return String.format(Locale.ROOT, "%.2f km²", squareMetres / (KILOMETRE * KILOMETRE));
        }
        return squareMetres >= HECTARE
                ? String.format(Locale.ROOT, "%.2f ha", squareMetres / HECTARE)
                : String.format(Locale.ROOT, "%.0f m²", squareMetres);
    }
}
