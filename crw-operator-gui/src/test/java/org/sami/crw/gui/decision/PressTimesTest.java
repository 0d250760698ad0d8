package org.sami.crw.gui.decision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PressTimesTest {
    private long now = 50_000;
    private final PressTimes presses = new PressTimes(() -> now);

    @Test
    void pressBeforeAQuestionWasShownIsNotMeantForIt() {
        presses.turned(true);

        assertThat(presses.isEarlier(49_999)).isTrue();
        assertThat(presses.isEarlier(50_000)).isFalse();
        assertThat(presses.isEarlier(51_000)).isFalse();
    }

    @Test
    void pressIsMeantForTheQuestionThatWasThereBefore() {
        presses.turned(true);
        now = 60_000;

        assertThat(presses.isEarlier(59_000)).isFalse();
    }

    @Test
    void pressWithinHalfASecondOfAQuestionThatCameByItselfDoesNotAnswerIt() {
        presses.turned(true);

        assertThat(presses.isUnread(49_999)).isTrue();
        assertThat(presses.isUnread(50_499)).isTrue();
        assertThat(presses.isUnread(50_500)).isFalse();
    }

    @Test
    void questionThatTheOperatorTurnedToIsAnsweredAtOnce() {
        presses.turned(false);

        assertThat(presses.isUnread(49_999)).isTrue();
        assertThat(presses.isUnread(50_000)).isFalse();
    }

    @Test
    void clockThatWasSetBackRefusesNoPress() {
        presses.turned(true);

        assertThat(presses.isEarlier(20_000)).isFalse();
        assertThat(presses.isUnread(20_000)).isFalse();
    }

    @Test
    void pressCountsWhereNoQuestionWasShown() {
        assertThat(presses.isEarlier(0)).isFalse();
        assertThat(presses.isUnread(0)).isFalse();
    }
}
