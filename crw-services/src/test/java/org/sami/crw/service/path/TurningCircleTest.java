package org.sami.crw.service.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

class TurningCircleTest {
    private static final GeoPoint HERE = GeoPoint.of(45.7, 10.72);

    @ParameterizedTest
    @CsvSource({"0,0", "10,0.00089", "45,0.0783", "90,0.5708", "-90,0.5708", "135,1.6491", "180,3.1416"})
    void sharpTurnsCostMoreThanSlightOnes(double turnDeg, double metresForEachMetreOfRadius) {
        assertThat(TurningCircle.perRadius(Math.toRadians(turnDeg)))
                .isCloseTo(metresForEachMetreOfRadius, within(1e-4));
    }

    /** Against a boat that drives the arc and the tangent in small steps, for a point that is 50 radii away. */
    @ParameterizedTest
    @CsvSource({"20", "60", "90", "120", "170"})
    void isWhatAnArcAndItsTangentAreLongerThanTwoLegs(double turnDeg) {
        double turn = Math.toRadians(turnDeg);
        double farX = 50 * Math.cos(turn);
        double farY = 50 * Math.sin(turn);
        double heading = 0;
        double driven = 0;
        double x = 0;
        double y = 0;
        double step = 1e-4;
        while (Math.atan2(farY - y, farX - x) > heading) {
            x += step * Math.cos(heading);
            y += step * Math.sin(heading);
            heading += step;
            driven += step;
        }
        driven += Math.hypot(farX - x, farY - y);

        assertThat(TurningCircle.perRadius(turn)).isCloseTo(driven - 50, within(0.05));
    }

    @Test
    void turnsOfAWayAreThoseAtItsPointsBetween() {
        List<GeoPoint> corner = List.of(HERE, Geodesy.offset(HERE, 50, 0), Geodesy.offset(HERE, 50, 50));
        List<GeoPoint> twice = List.of(HERE, HERE, Geodesy.offset(HERE, 50, 0));

        assertThat(TurningCircle.perRadius(corner)).isCloseTo(Math.PI / 2 - 1, within(1e-4));
        assertThat(TurningCircle.perRadius(twice)).isZero();
        assertThat(TurningCircle.perRadius(List.of(HERE))).isZero();
    }
}
