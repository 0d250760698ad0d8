package org.sami.crw.proxy;

import java.util.OptionalDouble;

/**
 * How much charge an aircraft uses in the air by the second, as seen of it: the time from one fall of the charge that it reports to the next. A landing, a charge
 * that rises, as that of another battery, and silence begin anew; what was seen before counts on.
 */
final class FlightUse {
    /** So much charge must have been used before it is said what a second takes, in percent. */
    static final double ENOUGH_PERCENT = 2;

    private static final double MOST_PERCENT =
            30; // then what was seen before counts half: batteries age, and loads change
    private static final long SILENCE_MS = 60_000; // it may have landed meanwhile
    private static final double MS_PER_S = 1000;

    private double last = Double.NaN;
    private long lastMs;
    private double fallen = Double.NaN; // the charge at its last fall in this flight
    private long fellMs;
    private double usedPercent;
    private double usedS;

    /** The aircraft reports its charge in percent of full. */
    void says(boolean inTheAir, double percent, long atMs) {
        if (!inTheAir || percent > last || atMs - lastMs > SILENCE_MS) {
            fallen = Double.NaN;
        } else if (percent < last) {
            if (!Double.isNaN(fallen)) {
                add(fallen - percent, (atMs - fellMs) / MS_PER_S);
            }
            fallen = percent;
            fellMs = atMs;
        }
        last = percent;
        lastMs = atMs;
    }

    private void add(double percent, double seconds) {
        if (usedPercent > MOST_PERCENT) {
            usedPercent /= 2;
            usedS /= 2;
        }
        usedPercent += percent;
        usedS += seconds;
    }

    /** What was seen. */
    FlightUsed used() {
        return new FlightUsed(usedPercent, usedS);
    }

    /** Counts what an earlier base saw, where nothing was seen since. */
    void goOnFrom(FlightUsed earlier) {
        if (usedS == 0) {
            usedPercent = earlier.percent();
            usedS = earlier.seconds();
        }
    }

    /** The charge that a second takes, in percent; empty before enough was seen. */
    OptionalDouble percentPerS() {
        return usedPercent >= ENOUGH_PERCENT && usedS > 0
                ? OptionalDouble.of(usedPercent / usedS)
                : OptionalDouble.empty();
    }
}
