package org.sami.boat.hull.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

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
        assertThat(check.question()).isEqualTo("left motor forward: does it push forward?");
        check.drive();
        check.answer(MotorAnswer.YES);
        check.drive();
        check.answer(MotorAnswer.REVERSED);

        assertThat(check.step()).contains(MotorStep.MOST_THRUST);
        assertThat(driven).containsExactly("0.3 0.0", "0.0 0.0", "0.0 0.3", "0.0 0.0");
        check.answer(MotorAnswer.LATER);
        check.answer(MotorAnswer.LATER);
        assertThat(check.step()).isEmpty();
        assertThat(check.settings().safeMaximum()).as("as before").isEqualTo(0.7);
        assertThat(check.settings().leftReversed()).isFalse();
        assertThat(check.settings().rightReversed()).isTrue();
        assertThat(check.settings().motorsChecked()).isTrue();
    }

    @Test
    void motorsOnTheOtherSideAreSwappedAndAskedAgain() {
        MotorCheck check = check(HullKind.DIFFERENTIAL);
        check.drive();
        check.answer(MotorAnswer.OTHER_SIDE);

        assertThat(check.step()).contains(MotorStep.LEFT_AHEAD);
        assertThat(check.settings().sidesSwapped()).isTrue();
        assertThat(check.settings().motorsChecked()).isFalse();
        assertThat(check.trouble()).isEqualTo("the motors are swapped in the settings: try again");
    }

    @Test
    void whatDoesNotMoveStaysToBeChecked() {
        MotorCheck check = check(HullKind.RUDDER);
        check.drive();
        check.answer(MotorAnswer.NOTHING);

        assertThat(check.step()).contains(MotorStep.THRUST_AHEAD);
        assertThat(check.trouble()).contains("cable");
        assertThat(check.settings().motorsChecked()).isFalse();
    }

    @Test
    void rudderThatTurnsTheWrongWayIsReversed() {
        MotorCheck check = check(HullKind.RUDDER);
        check.drive();
        check.answer(MotorAnswer.YES);
        check.drive();
        check.answer(MotorAnswer.REVERSED);

        assertThat(check.settings().rudderReversed()).isFalse(); // it was, as rudders usually are
        assertThat(check.settings().leftReversed()).isFalse();
    }

    @Test
    void nothingIsAnsweredThatWasNotDriven() {
        MotorCheck check = check(HullKind.DIFFERENTIAL);
        assertThatThrownBy(() -> check.answer(MotorAnswer.YES)).isInstanceOf(IllegalStateException.class);

        free = false; // the board is gone
        assertThat(check.drive()).isFalse();
        assertThatThrownBy(() -> check.answer(MotorAnswer.YES)).hasMessageStartingWith("nothing was driven yet");
    }

    /** A differential hull whose motors turn as they should. */
    private MotorCheck turning() {
        MotorCheck check = check(HullKind.DIFFERENTIAL);
        for (int i = 0; i < 2; i++) {
            check.drive();
            check.answer(MotorAnswer.YES);
        }
        return check;
    }

    @Test
    void thrustRisesWithEachYesAndTheLastThatWasBorneIsKept() {
        MotorCheck check = turning();
        driven.clear();

        assertThat(check.question()).isEqualTo("thrust at 30 % of full: did everything keep running?");
        assertThat(check.settings().safeMaximum())
                .as("what the vehicle has meanwhile")
                .isEqualTo(0.3);
        for (int i = 0; i < 3; i++) {
            check.drive();
            check.answer(MotorAnswer.YES);
        }
        assertThat(check.settings().safeMaximum()).isEqualTo(0.6);
        check.drive();
        check.answer(MotorAnswer.FALTERED);

        assertThat(check.settings().safeMaximum()).isEqualTo(0.5);
        assertThat(check.trouble()).isEqualTo("the most thrust is 50 % from now on");
        assertThat(check.step()).contains(MotorStep.STRAIGHT);
        assertThat(driven).contains("1.0 1.0");
    }

    @Test
    void thrustThatIsEnoughIsKeptAndFullThrustIsTheEnd() {
        MotorCheck enough = turning();
        enough.drive();
        enough.answer(MotorAnswer.YES);
        enough.drive();
        enough.answer(MotorAnswer.ENOUGH);
        assertThat(enough.settings().safeMaximum()).isEqualTo(0.4);

        MotorCheck full = turning();
        for (int tenths = 3; tenths <= 10; tenths++) {
            full.drive();
            full.answer(MotorAnswer.YES);
        }
        assertThat(full.settings().safeMaximum()).isEqualTo(1);
        assertThat(full.step()).contains(MotorStep.STRAIGHT);
    }

    @Test
    void hullThatFaltersWithLittleThrustStaysToBeChecked() {
        MotorCheck check = turning();
        check.drive();
        check.answer(MotorAnswer.FALTERED);

        assertThat(check.step()).contains(MotorStep.MOST_THRUST);
        assertThat(check.trouble()).contains("battery");
    }

    @Test
    void trimTurnsAgainstTheSideToWhichTheHullTurns() {
        MotorCheck check = turning();
        check.answer(MotorAnswer.LATER);
        driven.clear();
        check.drive();
        check.answer(MotorAnswer.PULLS_LEFT);
        check.drive();
        check.answer(MotorAnswer.PULLS_LEFT);
        check.drive();
        check.answer(MotorAnswer.PULLS_RIGHT);
        assertThat(check.question()).contains("with trim 3 %");
        check.drive();
        check.answer(MotorAnswer.YES);

        assertThat(check.settings().trim()).isEqualTo(0.03);
        assertThat(check.settings().motorsChecked()).isTrue();
        assertThat(driven.get(0)).isEqualTo("0.3 0.3");
        assertThat(driven.get(2)).isEqualTo((0.3 + 0.03) + " " + (0.3 - 0.03));
    }

    @Test
    void trimStaysWithinItsLimit() {
        MotorCheck check = turning();
        check.answer(MotorAnswer.LATER);
        for (int i = 0; i < 20; i++) {
            check.drive();
            check.answer(MotorAnswer.PULLS_RIGHT);
        }
        assertThat(check.trouble()).contains("more trim than 30 % is not possible");
        check.drive();
        check.answer(MotorAnswer.YES);

        assertThat(check.settings().trim()).isEqualTo(-HullSettings.MAX_TRIM);
    }

    @Test
    void answerOfAnotherStepIsRefused() {
        MotorCheck check = turning();
        check.drive();

        assertThatThrownBy(() -> check.answer(MotorAnswer.OTHER_SIDE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("thrust at 30 %");
    }
}
