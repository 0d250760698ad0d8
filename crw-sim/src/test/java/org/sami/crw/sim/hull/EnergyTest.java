package org.sami.crw.sim.hull;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.server.vehicle.LocalFrame;

/** What a simulated hull uses by its speed. */
class EnergyTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        drag                          | drag,hotel=0,battery=148
        DRAG, hotel=12.5, battery=150 | drag,hotel=12.5,battery=150
        0:12,1.5:240,3:1700           | 0:12,1.5:240,3:1700,battery=148
        """)
    void comesBackAsItWasWritten(String text, String written) {
        Energy energy = Energy.parse(text);

        assertThat(energy).hasToString(written);
        assertThat(Energy.parse(written)).isEqualTo(energy);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        ''               | '' is none of these
        fast             | 'fast' is none of these
        hotel=5          | energy needs drag, or a curve
        drag,hotel=-1    | the hotel load is 0 to 100000 W, not -1.0
        drag,battery=0   | the battery is 1 to 1000000 Wh, not 0.0
        drag,0:1,1:2     | a curve of its own goes without drag
        0:1,1:2,hotel=1  | a hotel load goes with drag
        1:1,2:2          | a power curve begins at 0 m/s
        0:1,1:x          | 'x' is no number
        """)
    void saysWhatIsWrong(String text, String said) {
        assertThatThrownBy(() -> Energy.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(said);
    }

    @Test
    void metreAtTwiceTheSpeedCostsFourTimesAsMuch() {
        double slow = percentPerMetre("drag", 1.5 / 3.2);
        double fast = percentPerMetre("drag", 3 / 3.2);

        assertThat(slow).isEqualTo(1 / 35.0, within(0.1 / 35)); // the spread of thesis 7.1.1
        assertThat(fast / slow).isEqualTo(4, within(0.01));
    }

    private static double percentPerMetre(String energy, double effort) {
        SimulatedHull hull = hull(energy);
        hull.setMotors(effort, effort);
        pass(hull, 20);
        double percent = hull.batteryPercent();
        double metres = hull.distanceM();
        pass(hull, 60);
        return (percent - hull.batteryPercent()) / (hull.distanceM() - metres);
    }

    @Test
    void hotelLoadEmptiesTheBatteryOfABoatAtRest() {
        SimulatedHull hull = hull("drag,hotel=14.8,battery=148");

        pass(hull, 3600);

        assertThat(hull.batteryPercent()).isEqualTo(90, within(1.0));
        assertThat(hull.distanceM()).isZero();
    }

    @Test
    void restCostsNothingWithoutAnOption() {
        SimulatedHull hull =
                new SimulatedHull(HullConfig.DEFAULT.with(Energy.PER_METRE), new LocalFrame(45.7, 10.72), 0, 0, 1);

        pass(hull, 3600);

        assertThat(hull.batteryPercent()).isEqualTo(100);
        assertThat(HullConfig.DEFAULT.with(Energy.PER_METRE)).isEqualTo(HullConfig.DEFAULT);
    }

    private static SimulatedHull hull(String energy) {
        return new SimulatedHull(HullConfig.DEFAULT.with(Energy.parse(energy)), new LocalFrame(45.7, 10.72), 0, 0, 1);
    }

    private static void pass(SimulatedHull hull, int seconds) {
        for (int i = 0; i < 10 * seconds; i++) {
            hull.step(0.1);
        }
    }
}
