package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.sami.journal.postgres.LeaseSight.Sight;

/** How a standby judges a lease whose row comes from another machine's database. */
class LeaseSightTest {
    private static final Duration LENGTH = Duration.ofSeconds(5);
    private static final long STEP_MILLIS = 200;

    private final LeaseSight sight = new LeaseSight(LENGTH);
    private long millis = 1_000_000;
    private boolean follows;

    @Test
    void aRowThatStandsStillForItsLengthIsOverWhateverItsClockSays() {
        for (String ends : new String[] {"1970-01-01 00:00:00+00", "2999-01-01 00:00:00+00"}) {
            LeaseSight each = new LeaseSight(LENGTH);
            look(each, holder(1, "before", true));
            assertThat(look(each, holder(1, ends, true))).isEqualTo(Sight.WATCHED);
            assertThat(lookFor(each, holder(1, ends, true), LENGTH.toMillis() - STEP_MILLIS))
                    .isEqualTo(Sight.WATCHED);
            assertThat(lookFor(each, holder(1, ends, true), STEP_MILLIS)).isEqualTo(Sight.OVER);
        }
    }

    @Test
    void aRowThatIsRenewedIsHeldForEver() {
        for (int renewal = 0; renewal < 100; renewal++) {
            assertThat(lookFor(sight, holder(1, "end " + renewal, true), LENGTH.toMillis() - STEP_MILLIS))
                    .isIn(Sight.HELD, Sight.WATCHED);
        }
    }

    @Test
    void aHolderThatDoesNotCountOnTheStandbyIsNotFollowedByItself() {
        look(sight, holder(1, "a", true));
        look(sight, holder(1, "b", false));

        assertThat(lookFor(sight, holder(1, "b", false), 10 * LENGTH.toMillis()))
                .isEqualTo(Sight.STANDS_STILL);
    }

    @Test
    void aStandbyThatNeverSawARenewalDoesNotKnow() {
        assertThat(lookFor(sight, holder(1, "a", true), 10 * LENGTH.toMillis())).isEqualTo(Sight.STANDS_STILL);
    }

    @Test
    void aLeaseThatWasGivenBackIsOverAtOnceWhereTheRowIsOfNow() {
        assertThat(look(sight, holder(1, "-infinity", false))).isEqualTo(Sight.STANDS_STILL);
        follows = true;
        assertThat(look(sight, holder(1, "-infinity", false))).isEqualTo(Sight.OVER);
    }

    @Test
    void aLeaseThatIsGivenBackBeforeItsEyesIsOver() {
        look(sight, holder(1, "a", false));

        assertThat(look(sight, holder(1, "-infinity", false))).isEqualTo(Sight.OVER);
    }

    @Test
    void aStandbyWhoseProcessOrMachineStoodStillHasToSeeARenewalFirst() {
        look(sight, holder(1, "a", true));
        look(sight, holder(1, "b", true));

        millis += 30_000;

        assertThat(lookFor(sight, holder(1, "b", true), 10 * LENGTH.toMillis())).isEqualTo(Sight.STANDS_STILL);
    }

    @Test
    void aDatabaseThatWasAwayMakesItForget() {
        look(sight, holder(1, "a", true));
        look(sight, holder(1, "b", true));

        sight.forget();

        assertThat(lookFor(sight, holder(1, "b", true), 10 * LENGTH.toMillis())).isEqualTo(Sight.STANDS_STILL);
    }

    private Sight lookFor(LeaseSight at, LeaseTable.Holder holder, long forMillis) {
        Sight last = Sight.HELD;
        for (long passed = 0; passed < forMillis; passed += STEP_MILLIS) {
            last = look(at, holder);
        }
        return last;
    }

    private Sight look(LeaseSight at, LeaseTable.Holder holder) {
        millis += STEP_MILLIS;
        return at.look(holder, millis * 1_000_000, follows);
    }

    private static LeaseTable.Holder holder(long epoch, String ends, boolean standbyMayTake) {
        return new LeaseTable.Holder(epoch, "laptop-1", Duration.ZERO, ends, "14:02:03", standbyMayTake);
    }
}
