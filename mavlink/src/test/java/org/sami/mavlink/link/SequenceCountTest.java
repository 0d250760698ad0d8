package org.sami.mavlink.link;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SequenceCountTest {
    private final SequenceCount count = new SequenceCount();

    @Test
    void nothingIsLostWhereNumbersFollowOneAnotherOverTheirEnd() {
        for (int i = 200; i < 700; i++) {
            count.came(1, 1, i % 256);
        }

        assertThat(count.messages()).isEqualTo(500);
        assertThat(count.lost()).isZero();
    }

    @Test
    void gapsAreCountedOfEachSenderAlone() {
        for (int i = 0; i < 100; i += 2) {
            count.came(1, 1, i);
            count.came(2, 1, i / 2);
        }

        assertThat(count.lost()).isEqualTo(49.0 / 149);
    }

    @Test
    void lateMessageIsNotLost() {
        for (int number : new int[] {0, 1, 3, 2, 4}) {
            count.came(1, 1, number);
        }

        assertThat(count.messages()).isEqualTo(5);
        assertThat(count.lost()).isZero();
    }
}
