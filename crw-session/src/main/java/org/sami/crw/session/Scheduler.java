package org.sami.crw.session;

/**
 * Time in milliseconds, and the way to have something done at a later moment of it. Whose time it is depends on the session: this
 * machine's ({@link RealTimeLoop}), or that of a simulated world.
 *
 * <p>All actions run on one thread, one after another. They may be scheduled from that thread only.
 */
public interface Scheduler {

    /** The time in milliseconds since the start of the session. */
    long nowMs();

    /**
     * Has an action run once at a moment, or as soon as can be after it. Actions of one moment run in the order in which they
     * were scheduled; one that is scheduled for now runs after those that are already waiting for now.
     */
    void at(long timeMs, Runnable action);

    /**
     * Has an action run once after a delay.
     *
     * @throws IllegalArgumentException if the delay is negative
     */
    default void after(long delayMs, Runnable action) {
        if (delayMs < 0) {
            throw new IllegalArgumentException("nothing can be scheduled " + -delayMs + " ms ago");
        }
        at(nowMs() + delayMs, action);
    }
}
