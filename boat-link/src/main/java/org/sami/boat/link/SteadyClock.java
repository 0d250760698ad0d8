package org.sami.boat.link;

import java.util.function.LongSupplier;

/**
 * Milliseconds that never run back, for timeouts at both ends of a link.
 *
 * <p>Made by {@link #ofThisMachine} it counts from zero and knows nothing of the wall clock. Over another source it takes the
 * steps that lead back out: where the source jumps back, this clock goes on from where it was, so that nothing that is timed
 * by it fires early, and late at most by what passed between two readings. Safe for use by several threads.
 */
public final class SteadyClock implements LongSupplier {
    private final LongSupplier sourceMs;
    private long lastSourceMs;
    private long nowMs;

    /** A clock that starts at zero and moves on with a source of milliseconds. */
    public SteadyClock(LongSupplier sourceMs) {
        this.sourceMs = sourceMs;
        lastSourceMs = sourceMs.getAsLong();
    }

    /** The monotonic clock of this machine. */
    public static SteadyClock ofThisMachine() {
        long start = System.nanoTime();
        return new SteadyClock(() -> (System.nanoTime() - start) / 1_000_000);
    }

    @Override
    public synchronized long getAsLong() {
        long source = sourceMs.getAsLong();
        nowMs += Math.max(0, source - lastSourceMs);
        lastSourceMs = source;
        return nowMs;
    }
}
