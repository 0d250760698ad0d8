package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BoatWordsTest {
    @ParameterizedTest
    @CsvSource({"1.46,1.5 m/s", "-0.04,0.0 m/s", "-0.2,-0.2 m/s", "0,0.0 m/s"})
    void speedThatIsRoundedToNothingHasNoSign(double mps, String text) {
        assertThat(BoatWords.speed(mps)).isEqualTo(text);
    }
}
