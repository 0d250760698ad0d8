package org.sami.boat.server;

import org.sami.boat.link.RateLimit;

/**
 * How much clients that do not command can make the boat say and write down: so that no observer fills the commander's link or the boat's
 * log. Taking the command is never limited, only its line in the log. For the thread that drives the boat.
 */
final class TransferLimits {
    private static final double WISHES_PER_SECOND = 2;
    private static final double WISHES_AT_ONCE = 20;
    private static final double LINES_PER_SECOND = 0.1;
    private static final double LINES_AT_ONCE = 100;

    private final RateLimit wishes = new RateLimit(WISHES_PER_SECOND, WISHES_AT_ONCE);
    private final RateLimit lines = new RateLimit(LINES_PER_SECOND, LINES_AT_ONCE);
    private long leftOut;

    /** Of one client. */
    static RateLimit wishesOfOne() {
        return new RateLimit(0.2, 3);
    }

    /** Whether a client's wish to command is to be passed on. */
    boolean takesWish(RateLimit ofClient, long nowMs) {
        return ofClient.take(nowMs) && wishes.take(nowMs);
    }

    /** Whether a change of who commands is to be written down; what is not is counted. */
    boolean takesLine(long nowMs) {
        boolean takes = lines.take(nowMs);
        leftOut += takes ? 0 : 1;
        return takes;
    }

    /** How many were not written down since this was asked last. */
    long takeLeftOut() {
        long count = leftOut;
        leftOut = 0;
        return count;
    }
}
