package org.sami.session.server;

import java.util.function.LongSupplier;

/** Allows so many events a second on average and so many at once. For one thread at a time. */
final class MessageAllowance {
    private static final double NANOS = 1e9;

    private final double perSecond;
    private final double most;
    private final LongSupplier nanos;
    private double left;
    private long atNanos;

    MessageAllowance(double perSecond, int most, LongSupplier nanos) {
        this.perSecond = perSecond;
        this.most = most;
        this.nanos = nanos;
        left = most;
        atNanos = nanos.getAsLong();
    }

    /** Whether one more event is allowed now; it counts if it is. */
    synchronized boolean allows() {
        long now = nanos.getAsLong();
        left = Math.min(most, left + (now - atNanos) / NANOS * perSecond);
        atNanos = now;
        if (left < 1) {
            return false;
        }
        left--;
        return true;
    }

    /** Whether one more event is allowed now; it does not count. */
    synchronized boolean hasLeft() {
        return left + (nanos.getAsLong() - atNanos) / NANOS * perSecond >= 1;
    }

    /** Whether nothing has happened for so long that it is as new. */
    synchronized boolean isFull() {
        return left + (nanos.getAsLong() - atNanos) / NANOS * perSecond >= most;
    }
}
