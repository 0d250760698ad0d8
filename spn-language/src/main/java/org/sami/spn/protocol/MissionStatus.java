package org.sami.spn.protocol;

/** How far a mission is that has not ended. */
public enum MissionStatus {
    /** Waits for its parameters. */
    WAITING,
    RUNNING,
    /** Stopped as a livelock. */
    HALTED
}
