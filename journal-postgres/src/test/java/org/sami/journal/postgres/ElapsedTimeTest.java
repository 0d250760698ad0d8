package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.junit.jupiter.api.Test;

/** A clock that counts the time in which the machine slept. */
class ElapsedTimeTest {
    private long nanos = 7_000_000_000L;
    private long millis = 1_000_000;
    private final ElapsedTime clock = new ElapsedTime(() -> nanos, () -> Instant.ofEpochMilli(millis));
    private final long began = clock.getAsLong();

    private void pass(long awakeMillis, long wallMillis) {
        nanos += awakeMillis * 1_000_000;
        millis += wallMillis;
    }

    private long passedMillis() {
        return (clock.getAsLong() - began) / 1_000_000;
    }

    @Test
    void countsWhatPassesWhileTheMachineIsAwake() {
        pass(300, 301);
        assertThat(passedMillis()).isEqualTo(300);
        pass(5000, 4999);
        assertThat(passedMillis()).isEqualTo(5300);
    }

    @Test
    void countsTheTimeOfASleepOnce() {
        pass(100, 30_100);
        assertThat(passedMillis()).isEqualTo(30_100);
        pass(100, 100);
        assertThat(passedMillis()).isEqualTo(30_200);
    }

    @Test
    void doesNotGoBackWithTheMachinesClock() {
        pass(100, -86_400_000);
        assertThat(passedMillis()).isEqualTo(100);
        pass(100, 100);
        assertThat(passedMillis()).isEqualTo(200);
    }
}
