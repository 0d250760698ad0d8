package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/** What the lease of a session bears (docs/decisions 0581). */
class LeaseTermsTest {
    private static final Duration STANDSTILL = Duration.ofSeconds(2);
    private static final Duration WAY_TO_THE_DATABASE = Duration.ofMillis(400);

    @Test
    void aBaseThatStandsStillForTwoSecondsHasTimeToRenewIt() {
        LeaseTerms terms = LeaseTerms.STANDARD;

        assertThat(terms.renewEvery().plus(STANDSTILL).plus(WAY_TO_THE_DATABASE))
                .isLessThan(terms.ownLimit());
    }

    @Test
    void aBaseStopsBeforeAnotherCanBegin() {
        assertThat(LeaseTerms.STANDARD.ownLimit().plus(WAY_TO_THE_DATABASE)).isLessThan(LeaseTerms.STANDARD.length());
    }
}
