package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SteadyClockTest {
    private long sourceMs = 1_000_000;

    @Test
    void countsFromZero() {
        SteadyClock clock = new SteadyClock(() -> sourceMs);
        assertThat(clock.getAsLong()).isZero();

        sourceMs += 250;
        assertThat(clock.getAsLong()).isEqualTo(250);
    }

    @Test
    void goesOnWhereItWasWhenItsSourceIsSetBackAnHour() {
        SteadyClock clock = new SteadyClock(() -> sourceMs);
        sourceMs += 400;
        assertThat(clock.getAsLong()).isEqualTo(400);
        sourceMs -= 3_600_000;
        assertThat(clock.getAsLong()).isEqualTo(400);
        sourceMs += 100;

        assertThat(clock.getAsLong()).isEqualTo(500);
    }

    @Test
    void clockOfThisMachineRuns() {
        SteadyClock clock = SteadyClock.ofThisMachine();
        long before = clock.getAsLong();
        while (clock.getAsLong() <= before) {
            Thread.onSpinWait();
        }

        assertThat(clock.getAsLong()).isBetween(before, before + 60_000);
    }
}
