package org.sami.boat.server.testing;

import java.util.function.LongSupplier;

/**
 * Milliseconds that can pass twenty times more slowly than for the process, so that what a program expects within seconds may take a minute on a busy machine.
 * Safe for use by several threads.
 */
public final class SlowableClock implements LongSupplier {
    private static final int TIMES = 20;

    private long readMs = ProcessClock.ms();
    private long twentieths = readMs * TIMES;
    private boolean slow;

    /** Whether it goes slowly from now on. */
    public synchronized void slow(boolean now) {
        read();
        slow = now;
    }

    @Override
    public synchronized long getAsLong() {
        read();
        return twentieths / TIMES;
    }

    private void read() {
        long nowMs = ProcessClock.ms();
        twentieths += (nowMs - readMs) * (slow ? 1 : TIMES);
        readMs = nowMs;
    }
}
