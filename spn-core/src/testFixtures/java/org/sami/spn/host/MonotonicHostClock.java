package org.sami.spn.host;

import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;

/**
 * The clock of a session at speed 1: counts on from a start by the machine's monotonic clock, so that setting the wall
 * clock changes nothing. After a resume it starts at the journal's last time: the time between did not pass.
 *
 * <p>Owns one daemon thread until it is closed.
 */
public final class MonotonicHostClock implements HostClock, AutoCloseable {
    private static final long NANOS_PER_MILLI = 1_000_000;

    private final long startMillis;
    private final long originNanos = System.nanoTime();
    private final ScheduledThreadPoolExecutor waker;
    private Future<?> pending;

    /**
     * A clock that starts now.
     *
     * @param startMillis the session's time now: 0, or the last time in the journal that is resumed
     */
    public MonotonicHostClock(long startMillis) {
        this.startMillis = startMillis;
        ThreadFactory daemons = action -> {
            Thread thread = Executors.defaultThreadFactory().newThread(action);
            thread.setName("session-clock");
            thread.setDaemon(true);
            return thread;
        };
        waker = new ScheduledThreadPoolExecutor(1, daemons);
        waker.setRemoveOnCancelPolicy(true);
        waker.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    }

    @Override
    public long nowMillis() {
        return startMillis + (System.nanoTime() - originNanos) / NANOS_PER_MILLI;
    }

    @Override
    public synchronized void wakeAt(long millis, Runnable action) {
        if (pending != null) {
            pending.cancel(false);
        }
        if (!waker.isShutdown()) {
            pending = waker.schedule(action, Math.max(0, millis - nowMillis()), TimeUnit.MILLISECONDS);
        }
    }

    /** Ends the clock's thread; an action that has not run never does. Time goes on. */
    @Override
    public synchronized void close() {
        waker.shutdownNow();
    }
}
