package org.sami.boat.hull.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.hull.settings.MotorCheck.Answer;

class MotorCheckTest {
    private final List<String> driven = new ArrayList<>();
    private boolean free = true;

    private MotorCheck check(HullKind kind) {
        return new MotorCheck(HullSettings.of(kind).build(), (port, starboard, forMs) -> {
            driven.add(port + " " + starboard);
            return free;
        });
    }

    @Test
    void reversedMotorIsReversedInTheSettings() {
        MotorCheck check = check(HullKind.DIFFERENTIAL);
        assertThat(check.step().orElseThrow().question()).isEqualTo("left motor forward: does it push forward?");
        check.drive();
        check.answer(Answer.YES);
        check.drive();
        check.answer(Answer.REVERSED);

        assertThat(check.step()).isEmpty();
        assertThat(driven).containsExactly("0.3 0.0", "0.0 0.0", "0.0 0.3", "0.0 0.0");
        assertThat(check.settings().leftReversed()).isFalse();
        assertThat(check.settings().rightReversed()).isTrue();
        assertThat(check.settings().motorsChecked()).isTrue();
    }

    @Test
    void motorsOnTheOtherSideAreSwappedAndAskedAgain() {
        MotorCheck check = check(HullKind.DIFFERENTIAL);
        check.drive();
        check.answer(Answer.OTHER_SIDE);

        assertThat(check.step()).contains(MotorCheck.Step.LEFT_AHEAD);
        assertThat(check.settings().sidesSwapped()).isTrue();
        assertThat(check.settings().motorsChecked()).isFalse();
        assertThat(check.trouble()).isEqualTo("the motors are swapped in the settings: try again");
    }

    @Test
    void whatDoesNotMoveStaysToBeChecked() {
        MotorCheck check = check(HullKind.RUDDER);
        check.drive();
        check.answer(Answer.NOTHING);

        assertThat(check.step()).contains(MotorCheck.Step.THRUST_AHEAD);
        assertThat(check.trouble()).contains("cable");
        assertThat(check.settings().motorsChecked()).isFalse();
    }

    @Test
    void rudderThatTurnsTheWrongWayIsReversed() {
        MotorCheck check = check(HullKind.RUDDER);
        check.drive();
        check.answer(Answer.YES);
        check.drive();
        check.answer(Answer.REVERSED);

        assertThat(check.settings().rudderReversed()).isFalse(); // it was, as rudders usually are
        assertThat(check.settings().leftReversed()).isFalse();
    }

    @Test
    void nothingIsAnsweredThatWasNotDriven() {
        MotorCheck check = check(HullKind.DIFFERENTIAL);
        assertThatThrownBy(() -> check.answer(Answer.YES)).isInstanceOf(IllegalStateException.class);

        free = false; // the board is gone
        assertThat(check.drive()).isFalse();
        assertThatThrownBy(() -> check.answer(Answer.YES)).hasMessageStartingWith("nothing was driven yet");
    }
}
