package org.sami.crw.sim.run;

import org.sami.crw.sim.clock.VirtualScheduler;
import org.sami.spn.host.HostClock;

/** The session's time of a run in process: the simulated world's. */
final class VirtualHostClock implements HostClock {
    private final VirtualScheduler scheduler;
    private long latest;

    VirtualHostClock(VirtualScheduler scheduler) {
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
