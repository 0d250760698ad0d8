package org.sami.spn.plannet;

/** How a place with a sub-mission is while a transition out of it fires. */
enum SubMode {
    /** Nobody visits it. */
    VACANT,
    /** Its one visit is complete: the instance has ended. */
    COMPLETE,
    /** It is not followed what its sub-mission does, and which tokens it holds. */
    OPEN
}
