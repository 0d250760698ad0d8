package org.sami.journal.postgres;

import java.time.InstantSource;
import java.util.function.LongSupplier;

/**
 * A clock in nanoseconds that never goes back and counts the time in which the machine slept, which {@link System#nanoTime} leaves out on some systems: what lies between two readings is the
 * longer of what that clock and the machine's own say. A machine's clock that is set forward counts too; then a lease seems to be over too early and is renewed. Safe for use by several threads.
 */
final class ElapsedTime implements LongSupplier {
    private static final long NANOS_A_MILLI = 1_000_000;

    /** Less is the difference of two clocks that tick. */
    private static final long SLEPT_MILLIS = 1000;

    private final LongSupplier awake;
    private final InstantSource wall;
    private long lastNanos;
    private long lastMillis;
    private long sleptNanos;

    /**
     * Begins at the first clock's reading.
     *
     * @param awake in nanoseconds; does not jump, and may stand still while the machine sleeps
     * @param wall the machine's clock, which may be set
     */
    ElapsedTime(LongSupplier awake, InstantSource wall) {
        this.awake = awake;
        this.wall = wall;
        lastNanos = awake.getAsLong();
        lastMillis = wall.millis();
    }

    @Override
    public synchronized long getAsLong() {
        long nanos = awake.getAsLong();
        long millis = wall.millis();
        long slept = millis - lastMillis - (nanos - lastNanos) / NANOS_A_MILLI;
        if (slept > SLEPT_MILLIS) {
            sleptNanos += slept * NANOS_A_MILLI;
        }
        lastNanos = nanos;
        lastMillis = millis;
        return nanos + sleptNanos;
    }
}
