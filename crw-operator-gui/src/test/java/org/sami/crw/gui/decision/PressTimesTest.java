package org.sami.crw.gui.decision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PressTimesTest {
    private long now = 50_000;
    private final PressTimes presses = new PressTimes(() -> now);

    @Test
    void pressBeforeAQuestionWasShownIsNotMeantForIt() {
        presses.turned();

        assertThat(presses.isEarlier(49_999)).isTrue();
        assertThat(presses.isEarlier(50_000)).isFalse();
        assertThat(presses.isEarlier(51_000)).isFalse();
    }

    @Test
    void pressIsMeantForTheQuestionThatWasThereBefore() {
        presses.turned();
        now = 60_000;

        assertThat(presses.isEarlier(59_000)).isFalse();
    }

    @Test
    void clockThatWasSetBackRefusesNoPress() {
        presses.turned();

        assertThat(presses.isEarlier(20_000)).isFalse();
    }

    @Test
    void pressCountsWhereNoQuestionWasShown() {
        assertThat(presses.isEarlier(0)).isFalse();
    }
}
