package org.sami.crw.service.reach;

/** What is assumed of boats that do not say how far a charge takes them ({@link Charge}). */
public final class Range {
    /** How far one percent of charge takes such a boat on average, in metres: about 3.5 km on a full battery. */
    public static final double METRES_PER_PERCENT = 35;

    /** A metre costs up to this many times the mean (thesis 7.1.1). */
    public static final double COSTLIEST_METRE = 1.1;

    private Range() {}
}
