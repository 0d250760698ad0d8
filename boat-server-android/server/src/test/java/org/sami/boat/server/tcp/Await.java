package org.sami.boat.server.tcp;

import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;

/** Waits for what happens on other threads, for a bounded time. */
final class Await {
    private static final long PAUSE_NANOS = 2_000_000;

    private Await() {}

    /** Returns once the condition holds; fails after the time. */
    static void until(String what, double seconds, BooleanSupplier condition) {
        long end = System.nanoTime() + (long) (seconds * 1e9);
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > end) {
                throw new AssertionError("not within " + seconds + " s: " + what);
            }
            LockSupport.parkNanos(PAUSE_NANOS);
        }
    }

    /** Returns once a number has not changed for a while; fails after the longer time. */
    static void untilStill(String what, double forSeconds, double seconds, IntSupplier number) {
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

    /** How many threads of this process have a name that begins so. */
    static long threads(String prefix) {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.isAlive() && thread.getName().startsWith(prefix))
                .count();
    }
}
