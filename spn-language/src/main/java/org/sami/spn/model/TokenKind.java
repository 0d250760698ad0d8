package org.sami.spn.model;

/** Which tokens a requirement speaks of (R-IN-1). */
public enum TokenKind {
    GENERIC,
    /** Proxy tokens; never task tokens. */
    ANY_PROXY,
    ANY_TASK,
    ANY_TOKEN,
    /** The task, or the tasks of the class, that the requirement names. */
    TASK,
    /** The tokens that the used occurrences name. */
    RELEVANT,
    /** Out edges only: tokens in the end places of the instances on the in places. */
    SUB_MISSION_TOKENS,
    /** No condition (in), or entry by nobody (out). */
    UNCONDITIONAL
}
