package org.sami.crw.proxy.tcp;

import java.util.SplittableRandom;

/**
 * The delay before the next connection attempt. It doubles up to a limit, with a jitter of a fifth, so that the links of a fleet do not all come back
 * at the same moment.
 */
final class Backoff {
    private static final double SPREAD = 0.2;

    private final long firstMs;
    private final long mostMs;
    private final SplittableRandom random;
    private long nextMs;

    Backoff(long firstMs, long mostMs, long seed) {
        this.firstMs = firstMs;
        this.mostMs = mostMs;
        random = new SplittableRandom(seed);
        nextMs = firstMs;
    }

    /** The time to wait now, in ms. */
    long next() {
        long wait = Math.round(nextMs * random.nextDouble(1 - SPREAD, 1 + SPREAD));
        nextMs = Math.min(mostMs, 2 * nextMs);
        return wait;
    }

    /** The longest time to wait, in ms: where a quick try makes no sense. */
    long longest() {
        nextMs = mostMs;
        return next();
    }

    /** It went well: the next wait is a short one again. */
    void reset() {
        nextMs = firstMs;
    }
}
