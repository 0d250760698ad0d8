package org.sami.crw.sim.run.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.sim.hull.HullConfig;

class BatteryThresholdsTest {
    @ParameterizedTest
    @CsvSource({"0,15,30", "420,15,30", "421,16,31", "691,25,40", "1400,50,65", "1540,55,70", "9000,55,70"})
    void criticalIsTheWayBackAndAQuarter(double farthestM, double critical, double low) {
        HullConfig hull = HullConfig.DEFAULT.withBatteryPercentPerM(1 / 35.0);

        BatteryThresholds thresholds = BatteryThresholds.forWayBackM(farthestM, hull);

        assertThat(thresholds).isEqualTo(new BatteryThresholds(low, critical));
    }
}
