package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.sami.journal.postgres.OtherLease.Row;

/** Whether another session of a pair is over, which decides whether a replica may become the database. */
class OtherLeaseTest {
    private static final Duration LENGTH = Duration.ofMillis(3500);
    private static final long STEP_MILLIS = 100;

    private final OtherLease lease = new OtherLease(LENGTH);
    private long millis = 1_000_000;

    private void look(Row row, boolean follows, long forMillis) {
        for (long passed = 0; passed < forMillis; passed += STEP_MILLIS) {
            millis += STEP_MILLIS;
            lease.follow(follows, millis * 1_000_000);
            lease.look(row, millis * 1_000_000);
        }
    }

    private static Row held(String ends, boolean standbyMayTake) {
        return new Row(1, ends, /* givenBack= */ false, standbyMayTake);
    }

    private static Row givenBack() {
        return new Row(1, "-infinity", /* givenBack= */ true, /* standbyMayTake= */ false);
    }

    @Test
    void goesOnWhereTheNetworkIsCutAndItsHolderDoesNotCountOnTheStandby() {
        look(held("a", false), true, 500);
        look(held("b", false), true, 500);

        look(held("b", false), false, 10 * LENGTH.toMillis());

        assertThat(lease.isOver()).isFalse();
    }

    @Test
    void isOverWhereItStoodStillThoughItsHolderCountsOnTheStandby() {
        look(held("a", true), true, 500);
        look(held("b", true), false, LENGTH.toMillis());
        assertThat(lease.isOver()).isFalse();

        look(held("b", true), false, STEP_MILLIS);

        assertThat(lease.isOver()).isTrue();
    }

    @Test
    void mayGoOnWhereItsRenewalWasNeverSeen() {
        look(held("a", true), false, 10 * LENGTH.toMillis());

        assertThat(lease.isOver()).isFalse();
    }

    @Test
    void isOverWhereItStoodStillWhileTheReplicaFollowedAndStaysSoWhenItNoLongerDoes() {
        look(held("a", false), true, LENGTH.toMillis());
        assertThat(lease.isOver()).isFalse();
        look(held("a", false), true, STEP_MILLIS);
        assertThat(lease.isOver()).isTrue();

        look(held("a", false), false, LENGTH.toMillis());
        assertThat(lease.isOver()).isTrue();
        look(held("b", false), false, STEP_MILLIS);
        assertThat(lease.isOver()).isFalse();
    }

    @Test
    void aMomentWithoutTheOtherDatabaseBeginsTheWaitAnew() {
        look(held("a", false), true, LENGTH.toMillis() - STEP_MILLIS);
        look(held("a", false), false, STEP_MILLIS);
        look(held("a", false), true, LENGTH.toMillis() - STEP_MILLIS);

        assertThat(lease.isOver()).isFalse();
    }

    @Test
    void isOverOnceItWasGivenBackUnlessThatMayBeOld() {
        look(givenBack(), false, 10 * LENGTH.toMillis());
        assertThat(lease.isOver()).isFalse();
        look(givenBack(), true, STEP_MILLIS);
        assertThat(lease.isOver()).isTrue();

        look(held("a", false), false, STEP_MILLIS);
        look(givenBack(), false, STEP_MILLIS);
        assertThat(lease.isOver()).isTrue();
    }
}
