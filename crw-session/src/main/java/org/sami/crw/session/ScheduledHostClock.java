package org.sami.crw.session;

import org.sami.spn.host.HostClock;

/** A session's time, as a scheduler has it. For the thread that the scheduler's actions run on. */
public final class ScheduledHostClock implements HostClock {
    private final Scheduler scheduler;
    private long latest;

    /** A clock that shows the scheduler's time. */
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
