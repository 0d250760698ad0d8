package org.sami.crw.proxy.status;

/** Whether a boat's motors are stopped until somebody releases them, and who had that done. */
public enum StopLatch {
    /** They are not. */
    NONE,
    /** This base did. */
    HERE,
    /** Another base did, or this one before it started anew. */
    ELSEWHERE
}
