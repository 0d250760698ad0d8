package org.sami.spn.plannet;

/** How a place with a sub-mission is while a transition out of it fires. */
enum SubMode {
    /** Nobody visits it. */
    VACANT,
    /** Its one visit is complete: the instance has ended. */
    COMPLETE,
    /** Of a shared sub-mission: one of its unused returns is used, which frees the tokens that it brought back (R-SHR-4, R-SHR-6). */
    RETURNED,
    /** It is not followed what its sub-mission does, and which tokens it holds. */
    OPEN
}
