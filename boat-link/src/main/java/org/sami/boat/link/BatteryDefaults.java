package org.sami.boat.link;

/** Thresholds of batteries, for boats and bases. {@code crw defaults} prints them. */
public final class BatteryDefaults {
    /** A rise of the charge by this much, in percent of full, means that the battery was charged or swapped. Boats and bases must use the same number. */
    public static final double RECHARGED_PERCENT = 5;

    /** Charge in percent below which the battery is low. */
    public static final double LOW_PERCENT = 30;

    /** Charge in percent below which the battery is critical, wherever the boat is. */
    public static final double CRITICAL_PERCENT = 15;

    /**
     * The battery is also critical where it holds less than this many times the way home: a tenth for metres that cost more than the mean, a quarter for
     * a current or an unknown detour.
     */
    public static final double HOME_RESERVE_FACTOR = 1.4;

    private BatteryDefaults() {}
}
