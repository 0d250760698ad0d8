package org.sami.boat.server.testing;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;

/** Waits for what happens on other threads and in other processes, in the time of the {@link ProcessClock}. */
public final class Await {
    /** Until it is given up; long, for a machine that has much else to do. */
    public static final double AT_MOST_S = 120;

    private static final long PAUSE_NANOS = 3_000_000;

    private Await() {}

    /** Returns after how many ms the condition held; fails after {@link #AT_MOST_S}. */
    public static long until(String what, BooleanSupplier condition) {
        return until(what, AT_MOST_S, condition);
    }

    /** The same for what takes longer on any machine. */
    public static long until(String what, double seconds, BooleanSupplier condition) {
        long startMs = ProcessClock.ms();
        boolean isLast = false; // a look that began in time may have waited for its answer until long after
        while (!condition.getAsBoolean()) {
            if (isLast) {
                throw new AssertionError("not within " + seconds + " s: " + what);
            }
            LockSupport.parkNanos(PAUSE_NANOS);
            isLast = ProcessClock.ms() - startMs > seconds * 1000;
        }
        return ProcessClock.ms() - startMs;
    }

    /** Fails if the condition ceases to hold within the time. */
    public static void holds(String what, double seconds, BooleanSupplier condition) {
        long startMs = ProcessClock.ms();
        while (ProcessClock.ms() - startMs < seconds * 1000) {
            if (!condition.getAsBoolean()) {
                throw new AssertionError("not for " + seconds + " s: " + what);
            }
            LockSupport.parkNanos(PAUSE_NANOS);
        }
    }

    /** Returns once a number has not changed for a while; fails after {@link #AT_MOST_S}. */
    public static void untilStill(String what, double forSeconds, IntSupplier number) {
        int[] last = {number.getAsInt()};
        long[] sinceMs = {ProcessClock.ms()};
        until(what, () -> {
            if (number.getAsInt() != last[0]) {
                last[0] = number.getAsInt();
                sinceMs[0] = ProcessClock.ms();
            }
            return ProcessClock.ms() - sinceMs[0] > forSeconds * 1000;
        });
    }

    /** Waits for a latch; an interruption ends that. */
    public static void latch(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** How many threads of this process have a name that begins so. */
    public static long threads(String prefix) {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.isAlive() && thread.getName().startsWith(prefix))
                .count();
    }
}
