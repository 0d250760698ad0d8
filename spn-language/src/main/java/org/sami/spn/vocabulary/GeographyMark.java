package org.sami.spn.vocabulary;

/** What a field of a geographic value means to the checks of plans. */
public enum GeographyMark {
    /** A list of areas that no robot enters. */
    AVOID,
    /** The area that no robot leaves. */
    WITHIN,
    /** An area that is driven in lanes. */
    LANES,
    /** The distance between two lanes, in metres. */
    LANE_SPACING
}
