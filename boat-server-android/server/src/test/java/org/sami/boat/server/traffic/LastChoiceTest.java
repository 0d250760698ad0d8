package org.sami.boat.server.traffic;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** For how long a choice among others stays in force. */
class LastChoiceTest {
    private static final CourseAndSpeed NORTH = new CourseAndSpeed(0, 1.5);

    private final LastChoice last = new LastChoice();

    @BeforeEach
    void choose() {
        last.set(NORTH, true, new CourseAndSpeed(1, 0.5), 1000);
    }

    private static CourseAndSpeed turned(double degrees) {
        return new CourseAndSpeed(Math.toRadians(degrees), 1.5);
    }

    @Test
    void choiceIsInForceUntilTheTickAfterTheNext() {
        assertThat(last.isInForce(NORTH, true, 1100)).isTrue();
        assertThat(last.isInForce(NORTH, true, 1200)).isFalse();
    }

    @Test
    void boatThatWantsToGoElsewhereChoosesAnew() {
        assertThat(last.isInForce(turned(9), true, 1100)).isTrue();
        assertThat(last.isInForce(turned(-11), true, 1100)).isFalse();
        assertThat(last.isInForce(turned(180), true, 1100)).isFalse();
    }

    @Test
    void boatThatHasNoWayAnyMoreChoosesAnew() {
        assertThat(last.isInForce(NORTH, false, 1100)).isFalse();
    }

    @Test
    void timeInForceCountsUntilTheNextChoice() {
        last.lasts(0.1);
        last.lasts(0.1);
        assertThat(last.sinceS()).isEqualTo(0.2);

        last.set(NORTH, true, NORTH, 1300);
        assertThat(last.sinceS()).isZero();
    }

    @Test
    void nothingIsInForceOnceNobodyIsThere() {
        last.forget();

        assertThat(last.isInForce(NORTH, true, 1000)).isFalse();
    }
}
