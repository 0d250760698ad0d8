package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.sami.journal.postgres.LeaseObservation.Verdict;

/** How a standby judges a lease whose row comes from another machine's database. */
class LeaseObservationTest {
    private static final Duration LENGTH = Duration.ofSeconds(5);
    private static final long STEP_MILLIS = 200;

    private final LeaseObservation observation = new LeaseObservation(LENGTH);
    private long millis = 1_000_000;
    private boolean follows;

    @Test
    void aRowThatStandsStillForItsLengthIsOverWhateverItsClockSays() {
        for (String ends : new String[] {"1970-01-01 00:00:00+00", "2999-01-01 00:00:00+00"}) {
            LeaseObservation each = new LeaseObservation(LENGTH);
            look(each, holder(1, "before", true));
            assertThat(look(each, holder(1, ends, true))).isEqualTo(Verdict.WATCHED);
            assertThat(lookFor(each, holder(1, ends, true), LENGTH.toMillis() - STEP_MILLIS))
                    .isEqualTo(Verdict.WATCHED);
            assertThat(lookFor(each, holder(1, ends, true), STEP_MILLIS)).isEqualTo(Verdict.OVER);
        }
    }

    @Test
    void aRowThatIsRenewedIsHeldForEver() {
        for (int renewal = 0; renewal < 100; renewal++) {
            assertThat(lookFor(observation, holder(1, "end " + renewal, true), LENGTH.toMillis() - STEP_MILLIS))
                    .isIn(Verdict.HELD, Verdict.WATCHED);
        }
    }

    @Test
    void aHolderThatDoesNotCountOnTheStandbyIsNotFollowedByItself() {
        look(observation, holder(1, "a", true));
        look(observation, holder(1, "b", false));

        assertThat(lookFor(observation, holder(1, "b", false), 10 * LENGTH.toMillis()))
                .isEqualTo(Verdict.STANDS_STILL);
    }

    @Test
    void aStandbyThatNeverSawARenewalDoesNotKnow() {
        assertThat(lookFor(observation, holder(1, "a", true), 10 * LENGTH.toMillis()))
                .isEqualTo(Verdict.STANDS_STILL);
    }

    @Test
    void aLeaseThatWasGivenBackIsOverAtOnceWhereTheRowIsOfNow() {
        assertThat(look(observation, holder(1, "-infinity", false))).isEqualTo(Verdict.STANDS_STILL);
        follows = true;
        assertThat(look(observation, holder(1, "-infinity", false))).isEqualTo(Verdict.OVER);
    }

    @Test
    void aLeaseThatIsGivenBackBeforeItsEyesIsOver() {
        look(observation, holder(1, "a", false));

        assertThat(look(observation, holder(1, "-infinity", false))).isEqualTo(Verdict.OVER);
    }

    @Test
    void aStandbyWhoseProcessOrMachineStoodStillHasToSeeARenewalFirst() {
        look(observation, holder(1, "a", true));
        look(observation, holder(1, "b", true));

        millis += 30_000;

        assertThat(lookFor(observation, holder(1, "b", true), 10 * LENGTH.toMillis()))
                .isEqualTo(Verdict.STANDS_STILL);
    }

    @Test
    void aStandbyThatStoodStillForLessThanALeaseGoesOnCounting() {
        look(observation, holder(1, "a", true));
        look(observation, holder(1, "b", true));

        millis += LENGTH.toMillis() - 2 * STEP_MILLIS;

        assertThat(look(observation, holder(1, "b", true))).isEqualTo(Verdict.WATCHED);
        assertThat(look(observation, holder(1, "b", true))).isEqualTo(Verdict.OVER);
    }

    @Test
    void aRenewalThatCameWhileTheStandbyStoodStillIsSeenAfterwards() {
        look(observation, holder(1, "a", true));
        look(observation, holder(1, "b", true));

        millis += LENGTH.toMillis() - 2 * STEP_MILLIS;

        assertThat(look(observation, holder(1, "c", true))).isEqualTo(Verdict.WATCHED);
        assertThat(lookFor(observation, holder(1, "c", true), LENGTH.toMillis() - STEP_MILLIS))
                .isEqualTo(Verdict.WATCHED);
        assertThat(look(observation, holder(1, "c", true))).isEqualTo(Verdict.OVER);
    }

    @Test
    void aHolderThatWentAloneWhileTheStandbyStoodStillIsNotFollowedByItself() {
        look(observation, holder(1, "a", true));
        look(observation, holder(1, "b", true));

        millis += LENGTH.toMillis() - 2 * STEP_MILLIS;

        assertThat(lookFor(observation, holder(1, "c", false), 10 * LENGTH.toMillis()))
                .isEqualTo(Verdict.STANDS_STILL);
    }

    @Test
    void aDatabaseThatWasAwayMakesItForget() {
        look(observation, holder(1, "a", true));
        look(observation, holder(1, "b", true));

        observation.forget();

        assertThat(lookFor(observation, holder(1, "b", true), 10 * LENGTH.toMillis()))
                .isEqualTo(Verdict.STANDS_STILL);
    }

    private Verdict lookFor(LeaseObservation at, LeaseTable.Holder holder, long forMillis) {
        Verdict last = Verdict.HELD;
        for (long passed = 0; passed < forMillis; passed += STEP_MILLIS) {
            last = look(at, holder);
        }
        return last;
    }

    private Verdict look(LeaseObservation at, LeaseTable.Holder holder) {
        millis += STEP_MILLIS;
        return at.look(holder, millis * 1_000_000, follows);
    }

    private static LeaseTable.Holder holder(long epoch, String ends, boolean standbyMayTake) {
        return new LeaseTable.Holder(epoch, "laptop-1", Duration.ZERO, ends, "14:02:03", standbyMayTake);
    }
}
