package org.sami.boat.server.testing;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * Milliseconds for which this process has run. While it stands still as a whole, because the machine does something else, they do
 * not count: nothing that is timed by them is overdue only since nobody could be there in time.
 */
public final class ProcessClock {
    private static final long STEP_NANOS = 5_000_000;

    /** Whoever looks at the clock after longer has stood still. */
    private static final long LONGEST_STEP_NANOS = 50_000_000;

    private static final AtomicLong COUNTED_NANOS = new AtomicLong();

    static {
        Thread counting = new Thread(ProcessClock::count, "process-clock");
        counting.setDaemon(true);
        counting.start();
    }

    private ProcessClock() {}

    private static void count() {
        long readNanos = System.nanoTime();
        while (true) {
            LockSupport.parkNanos(STEP_NANOS);
            long nowNanos = System.nanoTime();
            COUNTED_NANOS.addAndGet(Math.min(nowNanos - readNanos, LONGEST_STEP_NANOS));
            readNanos = nowNanos;
        }
    }

    /** How long the process has run since its first use, in ms. Called from any thread. */
    public static long ms() {
        return COUNTED_NANOS.get() / 1_000_000;
    }
}
