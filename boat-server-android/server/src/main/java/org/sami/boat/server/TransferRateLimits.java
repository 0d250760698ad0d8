package org.sami.boat.server;

import org.sami.boat.link.RateLimit;

/**
 * Limits what observers can make the boat send and log, so that none fills the commander's link or the boat's log. Taking the command is never limited,
 * only its line in the log. For the thread that drives the boat.
 */
final class TransferRateLimits {
    private static final double WISHES_PER_SECOND = 2;
    private static final double WISHES_AT_ONCE = 20;
    private static final double LINES_PER_SECOND = 0.1;
    private static final double LINES_AT_ONCE = 100;

    private final RateLimit wishes = new RateLimit(WISHES_PER_SECOND, WISHES_AT_ONCE);
    private final RateLimit lines = new RateLimit(LINES_PER_SECOND, LINES_AT_ONCE);
    private long leftOut;

    /** The limit of one client. */
    static RateLimit wishesOfOne() {
        return new RateLimit(0.2, 3);
    }

    /** Whether to pass on a client's wish to command. */
    boolean takesWish(RateLimit ofClient, long nowMs) {
        return ofClient.take(nowMs) && wishes.take(nowMs);
    }

    /** Whether to log a change of commander; the others are counted. */
    boolean takesLine(long nowMs) {
        boolean takes = lines.take(nowMs);
        leftOut += takes ? 0 : 1;
        return takes;
    }

    /** Number of changes not logged since the last call. */
    long takeLeftOut() {
        long count = leftOut;
        leftOut = 0;
        return count;
    }
}
