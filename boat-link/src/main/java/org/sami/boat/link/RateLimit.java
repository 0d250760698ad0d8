package org.sami.boat.link;

/**
 * How much of something is taken from one peer: so much a second for ever, and so much at once after a pause. It has no clock of its
 * own; all calls take milliseconds of one clock. For one thread.
 */
public final class RateLimit {
    private final double perSecond;
    private final double burst;
    private double left;
    private long atMs;
    private boolean begun;

    /**
     * A limit of which nothing is used yet.
     *
     * @param perSecond how much is taken a second in the long run; more than 0
     * @param burst how much is taken at once at most; at least 1
     */
    public RateLimit(double perSecond, double burst) {
        if (!(perSecond > 0 && burst >= 1)) {
            throw new IllegalArgumentException(perSecond + " a second, " + burst + " at once");
        }
        this.perSecond = perSecond;
        this.burst = burst;
        left = burst;
    }

    /** Takes one, if it is within the limit. */
    public boolean take(long nowMs) {
        return take(nowMs, 1);
    }

    /** Takes so much at once, if it is within the limit; else it takes nothing. */
    public boolean take(long nowMs, double amount) {
        if (begun && nowMs > atMs) {
            left = Math.min(burst, left + (nowMs - atMs) / 1000.0 * perSecond);
        }
        if (!begun || nowMs > atMs) {
            atMs = nowMs;
        }
        begun = true;
        if (left < amount) {
            return false;
        }
        left -= amount;
        return true;
    }
}
