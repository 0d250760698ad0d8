package org.sami.boat.server.testing;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;

/** Waits for what happens on other threads, for a bounded time. */
public final class Await {
    private static final long PAUSE_NANOS = 3_000_000;

    private Await() {}

    /** Returns after how many ms the condition held; fails after the time. */
    public static double until(String what, double seconds, BooleanSupplier condition) {
        long start = System.nanoTime();
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() - start > seconds * 1e9) {
                throw new AssertionError("not within " + seconds + " s: " + what);
            }
            LockSupport.parkNanos(PAUSE_NANOS);
        }
        return (System.nanoTime() - start) / 1e6;
    }

    /** Fails if the condition ceases to hold within the time. */
    public static void holds(String what, double seconds, BooleanSupplier condition) {
        long start = System.nanoTime();
        while (System.nanoTime() - start < seconds * 1e9) {
            if (!condition.getAsBoolean()) {
                throw new AssertionError("not for " + seconds + " s: " + what);
            }
            LockSupport.parkNanos(PAUSE_NANOS);
        }
    }

    /** Returns once a number has not changed for a while; fails after the longer time. */
    public static void untilStill(String what, double forSeconds, double seconds, IntSupplier number) {
        int[] last = {number.getAsInt()};
        long[] since = {System.nanoTime()};
        until(what, seconds, () -> {
            if (number.getAsInt() != last[0]) {
                last[0] = number.getAsInt();
                since[0] = System.nanoTime();
            }
            return System.nanoTime() - since[0] > forSeconds * 1e9;
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
