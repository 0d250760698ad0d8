package org.sami.session.client;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Which base a front tries next, and when: numbers only. */
class KnownBasesTest {
    private static final SessionAddress A = SessionAddress.parse("wss://10.0.0.5:8443");
    private static final SessionAddress B = SessionAddress.parse("wss://10.0.0.6:8443");
    private static final SessionAddress C = SessionAddress.parse("wss://10.0.0.7:8443");

    private static long fails(KnownBases bases) {
        bases.failed("no server answers at " + bases.current(), false);
        return bases.next();
    }

    private static List<Long> waits(KnownBases bases, int tries) {
        List<Long> waits = new ArrayList<>();
        for (int one = 0; one < tries; one++) {
            waits.add(fails(bases));
        }
        return waits;
    }

    @Test
    void oneBaseIsTriedAgainLaterAndLater() {
        KnownBases bases = new KnownBases(List.of(A));

        assertThat(bases.lost(false)).isEqualTo(1000);
        assertThat(waits(bases, 6)).containsExactly(1000L, 2000L, 4000L, 8000L, 8000L, 8000L);
    }

    @Test
    void ofSeveralTheLostOneIsTriedAtOnceThenTheOthersThenAllWithAPause() {
        KnownBases bases = new KnownBases(List.of(A));
        bases.add(List.of(A, B, C));

        assertThat(bases.lost(false)).isZero();
        assertThat(bases.current()).isEqualTo(A);
        assertThat(waits(bases, 9)).containsExactly(0L, 0L, 500L, 0L, 0L, 1000L, 0L, 0L, 1000L);
        assertThat(bases.current()).isEqualTo(A);
    }

    @Test
    void silentOneIsTriedLast() {
        KnownBases bases = new KnownBases(List.of(A, B));

        assertThat(bases.lost(true)).isZero();
        assertThat(bases.current()).isEqualTo(B);
    }

    @Test
    void pausesAreShortAgainOnceABaseHeldTheSession() {
        KnownBases bases = new KnownBases(List.of(A, B));
        waits(bases, 8);

        bases.holds(3);

        assertThat(waits(bases, 2)).containsExactly(0L, 500L);
    }

    @Test
    void baseThatWasFollowedByAnotherIsNeverGoneBackTo() {
        KnownBases bases = new KnownBases(List.of(A, B));
        bases.holds(7);
        fails(bases);
        bases.holds(8);

        assertThat(bases.isSuperseded(7)).isTrue();
        assertThat(bases.isSuperseded(8)).isFalse();
        assertThat(bases.isSuperseded(9)).isFalse();
    }

    @Test
    void baseThatWasLeftOutIsNotTakenUpAgainWhenAnotherNamesIt() {
        KnownBases bases = new KnownBases(List.of(A, B));

        assertThat(bases.leaveOut()).isTrue();
        bases.add(List.of(A, B, C));

        assertThat(bases.all()).containsExactly(B, C);
    }

    @Test
    void roundInWhichAStandbyAnsweredIsWorthAnother() {
        KnownBases bases = new KnownBases(List.of(A, B));
        bases.failed("no server answers", false);
        bases.next();
        bases.failed("a standby", true);

        assertThat(bases.isRoundOver()).isTrue();
        assertThat(bases.nobodyWaits()).isFalse();
        assertThat(bases.faults()).isEqualTo("no server answers; a standby");
        bases.next();
        assertThat(bases.nobodyWaits()).isTrue();
    }

    @Test
    void baseThatLetsThePersonInNotIsTriedNoLongerUnlessItIsTheLast() {
        KnownBases bases = new KnownBases(List.of(A, B));

        assertThat(bases.leaveOut()).isTrue();
        assertThat(bases.all()).containsExactly(B);
        assertThat(bases.leaveOut()).isFalse();
    }
}
