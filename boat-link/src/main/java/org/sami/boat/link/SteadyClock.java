package org.sami.boat.link;

import java.util.function.LongSupplier;

/**
 * Milliseconds that never run back, for timeouts at both ends of a link.
 *
 * <p>{@link #ofThisMachine} makes one that counts from zero, independent of the wall clock. Over another source it removes backward jumps: where the source
 * jumps back, this clock goes on from where it was. A timeout then never fires early, and at most as late as the time between two readings. Safe for
 * use by several threads.
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
