package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PowerCurveTest {
    @Test
    void metreAtTwiceTheSpeedCostsFourTimesAsMuchAgainstDrag() {
        PowerCurve drag = PowerCurve.drag(35, 1.5, 0);

        assertThat(drag.metresPerPercent(1.5)).isEqualTo(35, within(1e-9));
        assertThat(drag.metresPerPercent(3)).isEqualTo(35 / 4.0, within(1e-9));
        assertThat(drag.metresPerPercent(0.75)).isEqualTo(35 * 4, within(1e-9));
        assertThat(drag.percentPerHour(-3)).isEqualTo(drag.percentPerHour(3));
    }

    @Test
    void hotelLoadCostsAtRestTooAndMakesSlowMetresDear() {
        PowerCurve loaded = PowerCurve.drag(35, 1.5, 30);

        assertThat(loaded.percent(0, 3600)).isEqualTo(30);
        assertThat(loaded.metresPerPercent(1.5)).isLessThan(35);
        assertThat(loaded.economicMps(0.75, 1.5)).isBetween(0.75, 1.0);
        assertThat(loaded.metresPerPercent(0.1)).isLessThan(loaded.metresPerPercent(1.5));
    }

    @ParameterizedTest
    @CsvSource({"0, 10", "1, 20", "2, 90", "1.5, 43.75", "3, 280"})
    void curveGoesThroughItsPointsAndOnWithTheCubeOfTheSpeed(double mps, double percent) {
        double[] speeds = {0, 1, 2};
        double[] powers = {10, 20, 90};

        assertThat(new PowerCurve(speeds, powers).percentPerHour(mps)).isEqualTo(percent, within(1e-9));
    }

    @Test
    void boatSaysItsMeanAtItsUsualSpeed() {
        BoatPerformance boat = new BoatPerformance(OptionalDouble.empty(), OptionalDouble.of(2), OptionalDouble.empty())
                .with(PowerCurve.drag(40, 1, 0));

        assertThat(boat.metresPerPercent().getAsDouble()).isEqualTo(10, within(1e-9));
        assertThat(boat.metresPerPercent(1).getAsDouble()).isEqualTo(40, within(1e-9));
        assertThat(new BoatPerformance(OptionalDouble.of(35), OptionalDouble.empty(), OptionalDouble.empty())
                        .metresPerPercent(3))
                .hasValue(35);
    }

    @Test
    void refusesWhatIsNoCurve() {
        refused("begins at 0 m/s", new double[] {1, 2}, new double[] {1, 2});
        refused("speeds rise", new double[] {0, 2, 2}, new double[] {1, 2, 3});
        refused("power does not fall", new double[] {0, 1}, new double[] {2, 1});
        refused("greater than 0", new double[] {0, 1}, new double[] {0, 0});
        refused("2 to 32 speeds", new double[] {0}, new double[] {0});
        refused("not in", new double[] {0, 1}, new double[] {0, Double.NaN});
    }

    private static void refused(String words, double[] speeds, double[] percents) {
        assertThatThrownBy(() -> new PowerCurve(speeds, percents))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(words);
    }
}
