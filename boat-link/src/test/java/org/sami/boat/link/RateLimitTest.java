package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class RateLimitTest {
    @Test
    void takesItsBurstAtOnceAndItsRateFromThenOn() {
        RateLimit limit = new RateLimit(10, 5);
        int taken = 0;
        for (int i = 0; i < 100; i++) {
            taken += limit.take(0) ? 1 : 0;
        }
        assertThat(taken).isEqualTo(5);
        for (long ms = 1; ms <= 10_000; ms++) {
            taken += limit.take(ms) ? 1 : 0;
        }
        assertThat(taken).isEqualTo(105);
    }

    @Test
    void aLongPauseGivesNoMoreThanTheBurst() {
        RateLimit limit = new RateLimit(10, 5);
        limit.take(0);
        assertThat(limit.take(1_000_000, 5)).isTrue();
        assertThat(limit.take(1_000_000)).isFalse();
    }

    @Test
    void timeThatRunsBackGivesNothing() {
        RateLimit limit = new RateLimit(1, 1);
        assertThat(limit.take(1000)).isTrue();
        assertThat(limit.take(0)).isFalse();
        assertThat(limit.take(1500)).isFalse();
        assertThat(limit.take(2000)).isTrue();
    }

    @Test
    void refusesNonsense() {
        assertThatThrownBy(() -> new RateLimit(0, 1)).hasMessageContaining("0.0 a second");
        assertThatThrownBy(() -> new RateLimit(1, Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    }
}
