package org.sami.mavlink.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class BootClockTest {
    private final BootClock clock = new BootClock();

    @Test
    void clockThatGoesAsFastAsTheBasesIsNeverBehindWhateverIsLateByASecond() {
        assertThat(clock.isBehind(60_000, 1_000_000)).isFalse();
        assertThat(clock.isBehind(61_000, 1_002_000)).isFalse();
        assertThat(clock.isBehind(3_660_000, 4_600_000)).isFalse();
    }

    @Test
    void clockThatBeganAnewInSilenceIsBehindThoughItShowsMoreThanBefore() {
        clock.isBehind(60_000, 1_000_000);

        assertThat(clock.isBehind(115_000, 1_120_000)).isTrue();
    }

    @Test
    void itIsSaidAgainAfterThirtySecondsUntilTheRestartIsKnown() {
        clock.isBehind(60_000, 1_000_000);
        assertThat(clock.isBehind(115_000, 1_120_000)).isTrue();

        assertThat(clock.isBehind(116_000, 1_121_000)).isFalse();
        assertThat(clock.isBehind(145_000, 1_150_000)).isTrue();

        clock.restarted();
        assertThat(clock.isBehind(185_000, 1_190_000)).isFalse();
        assertThat(clock.isBehind(225_000, 1_230_000)).isFalse();
    }

    @Test
    void whatComesInOneRushAfterALinkStoodStillIsBehindOnce() {
        clock.isBehind(60_000, 1_000_000);

        assertThat(clock.isBehind(61_000, 1_040_000)).isTrue();
        assertThat(clock.isBehind(99_000, 1_040_100)).isFalse();
        assertThat(clock.isBehind(140_100, 1_080_100)).isFalse();
    }
}
