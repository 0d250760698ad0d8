package org.sami.journal.postgres;

import java.time.Duration;
import java.util.Optional;

/**
 * Whether another session of a pair is over for certain, as a standby sees its lease in a replica. A row that stands still says nothing by itself: the network may be cut, and the holder goes on where
 * it does not count on the standby. So it is over only where it was given back, or stood still for its length although its holder counts on the standby and was seen renewing it, or stood still
 * so long while the replica followed. What was over stays so until the row changes.
 */
final class OtherLease {
    private final long lengthNanos;
    private Optional<Row> seen = Optional.empty();
    private Optional<Long> followedSince = Optional.empty();
    private long sinceNanos;
    private boolean renewed;
    private boolean over;

    /**
     * What the row says.
     *
     * @param ends when the lease is over, by the clock of the database that wrote it
     * @param givenBack whether its holder gave it back
     * @param standbyMayTake whether its holder counts on the standby
     */
    record Row(long epoch, String ends, boolean givenBack, boolean standbyMayTake) {}

    /** Nothing seen yet of a lease that lasts so long. */
    OtherLease(Duration length) {
        lengthNanos = length.toNanos();
    }

    /**
     * Notes whether the replica gets and applies all that is written; more often than it looks at the row.
     *
     * @param nowNanos a clock that does not jump
     */
    void follow(boolean follows, long nowNanos) {
        followedSince = follows ? Optional.of(followedSince.orElse(nowNanos)) : Optional.empty();
    }

    /**
     * Looks at the row, which was read after the time that is given.
     *
     * @param nowNanos a clock that does not jump
     */
    void look(Row row, long nowNanos) {
        if (seen.isEmpty() || !seen.get().equals(row)) {
            renewed = seen.isPresent();
            seen = Optional.of(row);
            sinceNanos = nowNanos;
            followedSince = followedSince.map(before -> nowNanos);
            over = false;
        }
        over |= row.givenBack() ? renewed || followedSince.isPresent() : hasEnded(row, nowNanos);
    }

    private boolean hasEnded(Row row, long nowNanos) {
        boolean counted = renewed && row.standbyMayTake() && nowNanos - sinceNanos >= lengthNanos;
        return counted || (followedSince.isPresent() && nowNanos - followedSince.get() >= lengthNanos);
    }

    /** Whether nobody goes on with the session. */
    boolean isOver() {
        return over;
    }

    /** Whether it was renewed a moment ago, so that somebody surely goes on with it. */
    boolean isFresh(long nowNanos) {
        return !over && renewed && nowNanos - sinceNanos < lengthNanos;
    }
}
