package org.sami.crw.sim.clock;

/**
 * The time of the simulated world and the way to have something done at a later moment of it.
 *
 * <p>Times are virtual milliseconds since the start of the world. All actions run on the one thread that drives the
 * clock, one after another; time stands still while an action runs.
 */
public interface VirtualScheduler {

    /** The virtual time in milliseconds. */
    long nowMs();

    /**
     * Has an action run once at a moment. Actions of one moment run in the order in which they were scheduled; one that
     * is scheduled for now runs after those that are already waiting for now.
     *
     * @throws IllegalArgumentException if the moment lies in the past
     */
    void at(long timeMs, Runnable action);

    /**
     * Has an action run once after a delay.
     *
     * @throws IllegalArgumentException if the delay is negative
     */
    default void after(long delayMs, Runnable action) {
        at(nowMs() + delayMs, action);
    }
}
