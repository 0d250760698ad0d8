package org.sami.crw.service.reach;

/** How far a charge is sure to take a boat of the fleet. */
public final class Range {
    /** A metre costs up to a tenth more than the mean (thesis 7.1.1). */
    private static final double DEAREST = 1.1;

    private Range() {}

    /** Metres that a charge in percent of full lasts for, whatever happens within the fleet's experience. */
    public static double sureM(double percent) {
        return percent * WayCheck.METRES_PER_PERCENT / DEAREST;
    }
}
