package org.sami.boat.hull.board;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;

class MotorMixerTest {
    private static final HullSettings.Builder TWO_MOTORS =
            HullSettings.of(HullKind.DIFFERENTIAL).safeMaximum(0.5);

    private static String line(HullSettings hull, double port, double starboard) {
        byte[] bytes = BoardCommands.motors(hull.kind(), MotorMixer.mix(hull, port, starboard));
        assertThat(bytes.length).isLessThanOrEqualTo(BoardCommands.MAX_BYTES);
        return new String(bytes, StandardCharsets.US_ASCII);
    }

    @Test
    void bothMotorsAreScaledBySafeMaximum() {
        assertThat(line(TWO_MOTORS.build(), 1, -0.5)).isEqualTo("{\"m0\":{\"v\":0.500},\"m1\":{\"v\":-0.250}}\r\n");
    }

    @Test
    void moreThanFullEffortIsClipped() {
        assertThat(line(TWO_MOTORS.build(), 7, -7)).isEqualTo("{\"m0\":{\"v\":0.500},\"m1\":{\"v\":-0.500}}\r\n");
    }

    @Test
    void eachMotorIsReversedForItselfAndSidesAreSwapped() {
        HullSettings hull = HullSettings.of(HullKind.DIFFERENTIAL)
                .safeMaximum(1)
                .leftReversed(true)
                .sidesSwapped(true)
                .build();

        assertThat(line(hull, 1, 0.5)).isEqualTo("{\"m0\":{\"v\":0.500},\"m1\":{\"v\":-1.000}}\r\n");
    }

    @Test
    void trimHoldsOnlyWhileDriving() {
        HullSettings hull =
                HullSettings.of(HullKind.DIFFERENTIAL).safeMaximum(1).trim(0.1).build();

        assertThat(line(hull, 0.5, 0.5)).isEqualTo("{\"m0\":{\"v\":0.600},\"m1\":{\"v\":0.400}}\r\n");
        assertThat(line(hull, 0, 0)).isEqualTo("{\"m0\":{\"v\":0.000},\"m1\":{\"v\":0.000}}\r\n");
    }

    @Test
    void rudderHullHasNoReverseThrustAndItsRudderIsReversed() {
        HullSettings hull = HullSettings.of(HullKind.RUDDER)
                .safeMaximum(0.5)
                .steeringThrust(0)
                .build();

        assertThat(line(hull, 1, 0.5)).isEqualTo("{\"m0\":{\"v\":0.375},\"s0\":{\"p\":-0.250}}\r\n");
        assertThat(line(hull, -1, -1)).isEqualTo("{\"m0\":{\"v\":0.000},\"s0\":{\"p\":0.000}}\r\n");
    }

    @Test
    void rudderHullThatIsToTurnOnTheSpotHasALittleThrust() {
        HullSettings hull = HullSettings.of(HullKind.RUDDER)
                .safeMaximum(1)
                .steeringThrust(0.25)
                .build();

        assertThat(line(hull, 1, -1)).isEqualTo("{\"m0\":{\"v\":0.250},\"s0\":{\"p\":-1.000}}\r\n");
    }

    @Test
    void noNumberIsNoEffort() {
        assertThat(MotorMixer.mix(TWO_MOTORS.build(), Double.NaN, 1).areNone()).isTrue();
        assertThat(MotorMixer.mix(TWO_MOTORS.build(), 1, Double.POSITIVE_INFINITY)
                        .areNone())
                .isTrue();
    }
}
