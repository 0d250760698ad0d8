package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class FlightUseTest {
    private final FlightUse use = new FlightUse();
    private long atMs;

    /** So many seconds in the air, with a report each, in whole percent as vehicles have it. */
    private double fly(double percent, double percentPerS, int seconds) {
        double left = percent;
        for (int i = 0; i < seconds; i++) {
            atMs += 1000;
            left -= percentPerS;
            use.says(true, Math.ceil(left), atMs);
        }
        return left;
    }

    @Test
    void useIsKnownOnceEnoughWasUsedInTheAir() {
        double left = fly(100, 0.1, 21);
        assertThat(use.percentPerS()).isEmpty();

        fly(left, 0.1, 60);
        assertThat(use.percentPerS().orElseThrow()).isCloseTo(0.1, Offset.offset(0.005));
    }

    @Test
    void chargeThatFallsOnTheGroundIsNoUseOfFlight() {
        for (int i = 0; i < 50; i++) {
            atMs += 10_000;
            use.says(false, 100 - i, atMs);
        }

        assertThat(use.percentPerS()).isEmpty();
    }

    @Test
    void anotherBatteryAndSilenceAreNoUse() {
        fly(60, 0.1, 40);
        use.says(true, 100, atMs += 1000);
        use.says(true, 80, atMs += 1000);
        use.says(true, 50, atMs += 600_000);
        fly(50, 0.1, 60);

        assertThat(use.percentPerS().orElseThrow()).isCloseTo(0.1, Offset.offset(0.005));
    }

    @Test
    void useThatChangesIsFollowed() {
        double left = fly(100, 0.05, 600);
        fly(left, 0.1, 500);

        assertThat(use.percentPerS().orElseThrow()).isGreaterThan(0.08);
    }
}
