package org.sami.crw.console;

import java.util.Locale;

/** Numbers as the console writes them, whatever the machine's language. */
final class Numbers {
    private Numbers() {}

    /** With one decimal, which is left out where it is zero. */
    static String short1(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.format(Locale.ROOT, "%.1f", value);
    }

    /** Session time as minutes and seconds, {@code 3:07}. */
    static String clock(long millis) {
        return String.format(Locale.ROOT, "%d:%02d", millis / 60_000, millis / 1000 % 60);
    }
}
