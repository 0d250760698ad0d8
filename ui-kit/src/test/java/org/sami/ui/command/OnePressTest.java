package org.sami.ui.command;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class OnePressTest {
    private static final long MS = 1_000_000L;

    @Test
    void aDoubleClickAndAHeldKeyAreOnePressAndALaterOneIsAnother() {
        OnePress press = new OnePress();

        assertThat(press.isOwn(-5 * MS)).isTrue();
        assertThat(press.isOwn(200 * MS)).as("a double click").isFalse();
        for (long at = 230; at < 3000; at += 30) {
            assertThat(press.isOwn(at * MS)).as("a held key").isFalse();
        }
        assertThat(press.isOwn(4000 * MS)).isTrue();
    }
}
