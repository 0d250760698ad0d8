package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BatteryLevelTest {

    @ParameterizedTest
    @CsvSource({
        "100, 30, 15, NOMINAL",
        "30, 30, 15, NOMINAL",
        "29.999, 30, 15, LOW",
        "15, 30, 15, LOW",
        "14.999, 30, 15, CRITICAL",
        "0, 30, 15, CRITICAL",
        "20, 20, 20, NOMINAL",
        "19.999, 20, 20, CRITICAL",
        "0, 0, 0, NOMINAL",
    })
    void nominalFromTheLowThresholdUpAndLowFromTheCriticalOne(
            double percent, double low, double critical, BatteryLevel level) {
        assertThat(BatteryLevel.of(percent, low, critical)).isEqualTo(level);
    }
}
