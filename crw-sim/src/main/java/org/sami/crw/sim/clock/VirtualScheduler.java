package org.sami.crw.sim.clock;

import org.sami.crw.session.Scheduler;

/**
 * The time of the simulated world: virtual milliseconds since its start. It stands still while an action runs, and moves on when
 * the thread that drives the clock says so.
 */
public interface VirtualScheduler extends Scheduler {

    /**
     * Has an action run once at a moment, at exactly that time.
     *
     * @throws IllegalArgumentException if the moment lies in the past
     */
    @Override
    void at(long timeMs, Runnable action);
}
