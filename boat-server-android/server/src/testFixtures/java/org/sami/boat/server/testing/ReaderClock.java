package org.sami.boat.server.testing;

import java.util.function.LongSupplier;

/**
 * Milliseconds that pass for one reader, such as the thread of a simulated boat. Between two readings at most {@link #LONGEST_STEP_MS} are counted, so that
 * a boat which a busy machine kept waiting does not take one long step. {@link ProcessClock} counts the same for a whole process. For one reader; may be
 * called from any thread.
 */
public final class ReaderClock implements LongSupplier {
    /** Somewhat longer than the time between two ticks of a boat. */
    private static final long LONGEST_STEP_MS = 150;

    private long readNanos = System.nanoTime();
    private long countedNanos;

    @Override
    public synchronized long getAsLong() {
        long nowNanos = System.nanoTime();
        countedNanos += Math.min(nowNanos - readNanos, LONGEST_STEP_MS * 1_000_000);
        readNanos = nowNanos;
        return countedNanos / 1_000_000;
    }
}
