package org.sami.crw.operator.boat;

import java.util.Locale;

/** How old something is, in words: the one way in which ages are written. */
public final class Age {
    private static final double MINUTES_FROM_S = 100;

    private Age() {}

    /** Such as {@code 0.4 s}, {@code 12 s}, {@code 5 min} or {@code 1 h 20 min}; an age below zero is none. */
    public static String words(long millis) {
        double seconds = Math.max(0, millis) / 1000.0;
        if (seconds < 10) {
            return String.format(Locale.ROOT, "%.1f s", seconds);
        } else if (seconds < MINUTES_FROM_S) {
            return (long) seconds + " s";
        }
        long minutes = (long) (seconds / 60);
        return minutes < 60 ? minutes + " min" : minutes / 60 + " h " + minutes % 60 + " min";
    }
}
