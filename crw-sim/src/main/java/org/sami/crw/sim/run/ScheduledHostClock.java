package org.sami.crw.sim.run;

import org.sami.crw.sim.clock.Scheduler;
import org.sami.spn.host.HostClock;

/** The session's time of a run: that of its world. For the thread that the scheduler's actions run on. */
public final class ScheduledHostClock implements HostClock {
    private final Scheduler scheduler;
    private long latest;

    /** A clock that shows the world's time. */
    public ScheduledHostClock(Scheduler scheduler) {
        this.scheduler = scheduler;
    }

    @Override
    public long nowMillis() {
        return scheduler.nowMs();
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        long mine = ++latest;
        scheduler.at(Math.max(millis, scheduler.nowMs()), () -> {
            if (mine == latest) {
                action.run();
            }
        });
    }
}
