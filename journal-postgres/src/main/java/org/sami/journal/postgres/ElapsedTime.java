package org.sami.journal.postgres;

import java.util.OptionalLong;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * A clock in nanoseconds that never goes back and counts the time in which the machine slept, which {@link System#nanoTime} leaves out on some systems: what lies between two readings is the
 * longer of what that clock and another one say. Safe for use by several threads.
 */
final class ElapsedTime implements LongSupplier {
    private static final long NANOS_A_MILLI = 1_000_000;

    /** Less is the difference of two clocks that tick. */
    private static final long SLEPT_NANOS = 1_000_000_000;

    private final LongSupplier awake;
    private final Supplier<OptionalLong> counting;
    private OptionalLong lastCounting;
    private long lastAwake;
    private long sleptNanos;

    /**
     * Begins at the first clock's reading.
     *
     * @param awake in nanoseconds; does not jump, and may stand still while the machine sleeps
     * @param counting in nanoseconds; counts sleep. Where it cannot be read for a while, a sleep is counted once it can
     */
    ElapsedTime(LongSupplier awake, Supplier<OptionalLong> counting) {
        this.awake = awake;
        this.counting = counting;
        lastAwake = awake.getAsLong();
        lastCounting = counting.get();
    }

    /**
     * That of this machine. Sleep is counted by how long it has been on, which nobody can set. Only where the system does not say that (it is not Linux), the machine's clock is asked: there a clock
     * that is set back at waking hides the sleep, and one that is set forward lets a lease seem to be over too early.
     */
    static ElapsedTime ofThisMachine() {
        return new ElapsedTime(System::nanoTime, counting(SinceBoot::nanos, System::currentTimeMillis));
    }

    /**
     * The clock that counts sleep: how long the machine has been on, where it says so, else its clock.
     *
     * @param wallMillis the machine's clock, which may be set
     */
    static Supplier<OptionalLong> counting(Supplier<OptionalLong> sinceBoot, LongSupplier wallMillis) {
        return sinceBoot.get().isPresent() ? sinceBoot : () -> OptionalLong.of(wallMillis.getAsLong() * NANOS_A_MILLI);
    }

    @Override
    public synchronized long getAsLong() {
        long nowAwake = awake.getAsLong();
        OptionalLong nowCounting = counting.get();
        if (nowCounting.isPresent()) {
            if (lastCounting.isPresent()) {
                long slept = nowCounting.getAsLong() - lastCounting.getAsLong() - (nowAwake - lastAwake);
                if (slept > SLEPT_NANOS) {
                    sleptNanos += slept;
                }
            }
            lastAwake = nowAwake;
            lastCounting = nowCounting;
        }
        return nowAwake + sleptNanos;
    }
}
