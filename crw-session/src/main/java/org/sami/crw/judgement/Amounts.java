package org.sami.crw.judgement;

import java.util.Locale;

/** Lengths, times and shares as people read them. */
final class Amounts {
    private static final double MANY = 99.05;

    private Amounts() {}

    static String length(double metres) {
        if (metres < 950) {
            return String.format(Locale.ROOT, "%.0f m", metres);
        }
        return String.format(Locale.ROOT, metres < 9_950 ? "%.1f km" : "%,.0f km", metres / 1000);
    }

    static String time(double seconds) {
        if (seconds < 90) {
            return String.format(Locale.ROOT, "%.0f s", seconds);
        }
        double minutes = seconds / 60;
        return minutes < 90
                ? String.format(Locale.ROOT, "%.0f min", minutes)
                : String.format(Locale.ROOT, minutes < 600 ? "%.1f h" : "%,.0f h", minutes / 60);
    }

    /** A part of something, 0 to 1, in percent: never all of it, or nothing, where it is not. */
    static String percent(double part) {
        double percent = 100 * part;
        boolean coarse = (percent >= 0.95 && percent < MANY) || percent >= 100;
        return coarse
                ? String.format(Locale.ROOT, "%.0f %%", percent)
                : String.format(Locale.ROOT, "%.1f %%", Math.min(percent, 99.9));
    }
}
