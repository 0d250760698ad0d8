package org.sami.boat.server.testing;

import java.util.function.LongSupplier;

/**
 * Milliseconds for which the one who reads this clock has run, such as the thread of one boat. The time for which it could not read, because the
 * machine was busy with other threads, does not count: no step of a simulated boat is longer than {@link #LONGEST_STEP_MS}, and what it does depends on
 * no other load. One clock for each reader; may be read from any thread.
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
