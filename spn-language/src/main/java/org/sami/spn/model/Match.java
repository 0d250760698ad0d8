package org.sami.spn.model;

/** How many tokens an in requirement wants (R-IN-2; thesis 4.1.4). */
public enum Match {
    ZERO,
    LESS_THAN,
    AT_LEAST,
    EXACTLY,
    /** Relevant only: every named token is here. */
    ALL
}
