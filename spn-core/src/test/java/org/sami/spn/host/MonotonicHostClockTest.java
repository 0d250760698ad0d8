package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class MonotonicHostClockTest {
    @Test
    void countsOnFromItsStart() {
        try (MonotonicHostClock clock = new MonotonicHostClock(90_000)) {
            long first = clock.nowMillis();
            assertThat(first).isBetween(90_000L, 3_600_000L);
            assertThat(clock.nowMillis()).isGreaterThanOrEqualTo(first);
        }
    }

    @Test
    void wakesNotBeforeTheTime() throws Exception {
        try (MonotonicHostClock clock = new MonotonicHostClock(0)) {
            CompletableFuture<Long> woken = new CompletableFuture<>();
            clock.wakeAt(20, () -> woken.complete(clock.nowMillis()));
            assertThat(woken.get(60, TimeUnit.SECONDS)).isGreaterThanOrEqualTo(20);
        }
    }

    @Test
    void aLaterCallReplacesAnEarlierOne() throws Exception {
        try (MonotonicHostClock clock = new MonotonicHostClock(0)) {
            CompletableFuture<String> woken = new CompletableFuture<>();
            clock.wakeAt(3_600_000, () -> woken.complete("replaced"));
            clock.wakeAt(1, () -> woken.complete("kept"));
            assertThat(woken.get(60, TimeUnit.SECONDS)).isEqualTo("kept");
        }
    }

    @Test
    void aClosedClockStillTellsTheTimeAndWakesNobody() {
        MonotonicHostClock clock = new MonotonicHostClock(5);
        clock.close();
        clock.wakeAt(0, () -> {
            throw new AssertionError("woken");
        });
        assertThat(clock.nowMillis()).isGreaterThanOrEqualTo(5);
    }
}
