package org.sami.journal.postgres;

import java.time.Duration;

/**
 * How long a lease lasts and how it is kept.
 *
 * @param length by the database's clock, from the moment at which it was taken or renewed
 * @param renewEvery how often its holder renews it
 * @param ownLimit by the holder's clock, from the moment before it asked: after that the holder takes it to be over. Shorter than the length, so that a holder whose network is cut stops
 *     before another can begin
 */
record LeaseTerms(Duration length, Duration renewEvery, Duration ownLimit) {
    /** Of a session: a base that died is followed by another after 3.5 s; one that stands still for 2 s keeps it. */
    static final LeaseTerms STANDARD =
            new LeaseTerms(Duration.ofMillis(3500), Duration.ofMillis(500), Duration.ofSeconds(3));

    LeaseTerms {
        if (ownLimit.compareTo(length) > 0) {
            throw new IllegalArgumentException("ownLimit " + ownLimit + " is longer than the lease, " + length);
        }
    }
}
