package org.sami.mavlink.link;

import java.time.Instant;
import java.util.function.Supplier;

/**
 * The time of signatures: tens of microseconds since 2015. It only goes on, and follows the latest time that a signed message had, as the protocol asks. Safe for
 * use by several threads.
 */
final class SigningClock {
    private static final long START_S = Instant.parse("2015-01-01T00:00:00Z").getEpochSecond();
    private static final long A_SECOND = 100_000;
    private static final long NANOS = 10_000;

    private final Supplier<Instant> now;
    private long latest;

    SigningClock(Supplier<Instant> now) {
        this.now = now;
    }

    /** A time for a message that is signed now, later than all before. */
    synchronized long next() {
        latest = Math.max(latest + 1, wall());
        return latest;
    }

    /** The time now. */
    synchronized long present() {
        return Math.max(latest, wall());
    }

    /** A message with a right signature had this time. */
    synchronized void heard(long time) {
        latest = Math.max(latest, time);
    }

    private long wall() {
        Instant instant = now.get();
        return (instant.getEpochSecond() - START_S) * A_SECOND + instant.getNano() / NANOS;
    }
}
