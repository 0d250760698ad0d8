package org.sami.crw.proxy.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class BackoffTest {
    private static List<Long> waits(long seed) {
        return Stream.generate(new Backoff(100, 1000, seed)::next).limit(8).toList();
    }

    @Test
    void waitsTwiceAsLongEachTimeUpToALimitGiveOrTakeAFifth() {
        long[] middles = {100, 200, 400, 800, 1000, 1000, 1000, 1000};
        List<Long> waits = waits(7);

        for (int i = 0; i < middles.length; i++) {
            assertThat(waits.get(i)).isBetween(middles[i] * 8 / 10, middles[i] * 12 / 10);
        }
    }

    @Test
    void jitterFollowsFromTheSeed() {
        assertThat(waits(7)).isEqualTo(waits(7)).isNotEqualTo(waits(8));
    }

    @Test
    void startsShortAgainAfterSuccess() {
        Backoff backoff = new Backoff(100, 1000, 1);
        assertThat(backoff.longest()).isBetween(800L, 1200L);
        backoff.reset();

        assertThat(backoff.next()).isBetween(80L, 120L);
    }
}
