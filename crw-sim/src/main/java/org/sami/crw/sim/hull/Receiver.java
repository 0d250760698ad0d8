package org.sami.crw.sim.hull;

import java.util.Locale;

/** When a boat gets a new position, and how its compass begins. */
public enum Receiver {
    /** A position with each tick, a compass that is right from the start. */
    STEADY(30),
    /**
     * As in logs of the boats of 2016 and 2013: a position every 1 to 2 s, now and then none for up to 18 s, and a compass that is off by 130° in
     * its first 10 s and by 62° in the next. Assumed are how often positions stay away, after one in sixty of them, and how often they jump, every
     * ten minutes.
     */
    LOGGED(600);

    private final double jumpIntervalS;

    Receiver(double jumpIntervalS) {
        this.jumpIntervalS = jumpIntervalS;
    }

    /** Seconds from one jump of the position to the next, on the average. */
    double jumpIntervalS() {
        return jumpIntervalS;
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * What {@link #toString} wrote.
     *
     * @throws IllegalArgumentException for another text
     */
    static Receiver parse(String text) {
        return valueOf(text.toUpperCase(Locale.ROOT));
    }
}
