package org.sami.mavlink.vehicle;

/**
 * Compares an autopilot's clock, which begins at its start, with the base's. Where it is behind what it was, the autopilot has started again while it was not heard, or what it says comes late,
 * as after a link that stood still. Used by one thread.
 */
final class BootClock {
    /** A radio holds a message back for less. */
    private static final long BEHIND_MS = 5_000;

    /** Between two times that it is said, so that a link on which all comes late is not loaded. */
    private static final long TELL_MS = 30_000;

    private long startMs = Long.MAX_VALUE; // on the base's clock, the earliest that fits what it said
    private long toldMs = Long.MIN_VALUE / 2;

    /**
     * Receives the autopilot's clock. True where it is behind, and that was not said within the last 30 s.
     *
     * @param bootMs since its start
     * @param nowMs on the base's clock
     */
    boolean isBehind(long bootMs, long nowMs) {
        long start = nowMs - bootMs;
        startMs = Math.min(startMs, start);
        if (start - startMs <= BEHIND_MS || nowMs - toldMs < TELL_MS) {
            return false;
        }
        toldMs = nowMs;
        return true;
    }

    /** The autopilot has started again: its clock begins anew. */
    void restarted() {
        startMs = Long.MAX_VALUE;
    }
}
