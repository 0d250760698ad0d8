package org.sami.crw.service.reach;

/** How far a charge takes a boat of the fleet. */
public final class Range {
    /** How far one percent of charge takes a boat on average, in metres: about 3.5 km on a full battery. */
    public static final double METRES_PER_PERCENT = 35;

    /** A metre costs up to this many times the mean (thesis 7.1.1). */
    public static final double COSTLIEST_METRE = 1.1;

    private Range() {}

    /** How far a charge in percent of full is sure to last, in metres: also where each metre costs the most. */
    public static double sureM(double percent) {
        return percent * METRES_PER_PERCENT / COSTLIEST_METRE;
    }
}
