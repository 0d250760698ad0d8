package org.sami.ui.geo;

import java.util.Locale;
import org.sami.spn.value.GeoPoint;

/** How coordinates are written. All are read again by {@link Coordinates#parse}; altitudes are left alone. */
public enum CoordinateNotation {
    /** Degrees with six decimals, which is about 0.1 m: {@code 45.700000, 10.720000}. */
    DECIMAL_DEGREES("Decimal degrees") {
        @Override
        public String format(GeoPoint point) {
            return String.format(Locale.ROOT, "%.6f, %.6f", point.latDeg(), point.lonDeg());
        }
    },
    /** Degrees, and minutes with four decimals: {@code 45° 42.0000' N, 10° 43.2000' E}. */
    DEGREES_MINUTES("Degrees and minutes") {
        @Override
        public String format(GeoPoint point) {
            return minutes(point.latDeg(), "N", "S") + ", " + minutes(point.lonDeg(), "E", "W");
        }
    },
    /** Zone with the latitude's band, easting and northing in metres: {@code 32T 633842 5062301}. */
    UTM("UTM") {
        @Override
        public String format(GeoPoint point) {
            return UtmPoint.of(point).map(UtmPoint::utm).orElseGet(() -> DECIMAL_DEGREES.format(point));
        }
    },
    /** The military grid: {@code 32T PR 33842 62301}. */
    MGRS("MGRS") {
        @Override
        public String format(GeoPoint point) {
            return UtmPoint.of(point).map(MilitaryGrid::format).orElseGet(() -> DECIMAL_DEGREES.format(point));
        }
    };

    private static final int TEN_THOUSANDTHS = 10_000;
    private static final long PER_DEGREE = 60L * TEN_THOUSANDTHS;

    private final String label;

    CoordinateNotation(String label) {
        this.label = label;
    }

    /** What people call it. */
    public String label() {
        return label;
    }

    /** A point in this notation; near the poles, where the grids of metres end, in decimal degrees. */
    public abstract String format(GeoPoint point);

    private static String minutes(double degrees, String positive, String negative) {
        long parts = Math.round(Math.abs(degrees) * PER_DEGREE); // rounded once, so that no 60 minutes are written
        return String.format(
                Locale.ROOT,
                "%d° %07.4f' %s",
                parts / PER_DEGREE,
                (parts % PER_DEGREE) / (double) TEN_THOUSANDTHS,
                degrees < 0 ? negative : positive);
    }
}
