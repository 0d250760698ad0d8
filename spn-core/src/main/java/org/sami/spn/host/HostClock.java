package org.sami.spn.host;

/** The session's time: the only clock that a host knows. */
public interface HostClock {
    /** Milliseconds since the session began; never goes back, whatever the wall clock does. */
    long nowMillis();

    /**
     * Runs an action once, at or after a time, on a thread of the clock's. A later call replaces an earlier one that has
     * not run.
     */
    void wakeAt(long millis, Runnable action);
}
