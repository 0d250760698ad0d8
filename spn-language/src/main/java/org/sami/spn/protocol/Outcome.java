package org.sami.spn.protocol;

/** How a mission ended. */
public enum Outcome {
    /** It entered an end place. */
    ENDED,
    /** It was completed from outside. */
    COMPLETED,
    ABORTED,
    /** Stopped as a livelock, its marking intact; it does not react until it is aborted. */
    HALTED
}
