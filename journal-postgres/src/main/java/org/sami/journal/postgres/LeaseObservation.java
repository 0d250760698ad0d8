package org.sami.journal.postgres;

import java.time.Duration;
import java.util.Optional;

/**
 * Judges a lease by how long a standby has seen its row unchanged: the row comes from another machine's database, whose clock the standby cannot use. The standby measures with its own
 * monotonic clock. The holder renews the row and waits until the replica has applied it. It counts its own limit from before that request, so its lease ends before the standby judges it over.
 *
 * <p>Whether the holder counts on this standby stands in the row. A standby that was away, as its database did not answer or its machine slept, may have missed that it no longer does: it has to
 * see the row renewed again before it goes on by itself. A standby that did not look for less than a lease's length has missed nothing: a row that is the same before and after stood still all the
 * while, as each renewal changes it.
 */
final class LeaseObservation {
    private final Duration length;
    private Optional<LeaseTable.Holder> seen = Optional.empty();
    private long sinceNanos;
    private long lookNanos;
    private boolean renewed;

    /** How a lease looks. */
    enum Verdict {
        /** Its holder renews it; this standby could not go on by itself. */
        HELD,
        /** Its holder renews it, and this standby goes on by itself where that ends. */
        WATCHED,
        /** Nobody holds it: it may be taken. */
        OVER,
        /** It stands still, but its holder may go on: it did not count on this standby, or this one does not know. */
        STANDS_STILL
    }

    /**
     * Nothing seen yet.
     *
     * @param length how long a lease lasts
     */
    LeaseObservation(Duration length) {
        this.length = length;
    }

    /**
     * Looks at the row.
     *
     * @param nowNanos a clock that does not jump, and counts while the machine sleeps
     * @param follows whether the row is of now: an old replica, which gets nothing, has an old row
     */
    Verdict look(LeaseTable.Holder holder, long nowNanos, boolean follows) {
        if (seen.isPresent() && nowNanos - lookNanos > length.toNanos()) {
            forget();
        }
        lookNanos = nowNanos;
        boolean changed = seen.isEmpty()
                || seen.get().epoch() != holder.epoch()
                || !seen.get().ends().equals(holder.ends());
        if (changed) {
            renewed = seen.isPresent();
            sinceNanos = nowNanos;
            seen = Optional.of(holder);
        }
        if (holder.isGivenBack()) {
            return renewed || follows ? Verdict.OVER : Verdict.STANDS_STILL;
        }
        boolean mayTake = renewed && holder.standbyMayTake();
        if (nowNanos - sinceNanos < length.toNanos()) {
            return mayTake ? Verdict.WATCHED : Verdict.HELD;
        }
        return mayTake ? Verdict.OVER : Verdict.STANDS_STILL;
    }

    /** Forgets what was seen: the database did not answer, and meanwhile the holder may have been told to go on alone. */
    void forget() {
        seen = Optional.empty();
        renewed = false;
    }
}
