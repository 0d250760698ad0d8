package org.sami.crw.sim.run.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SpeedTest {
    @ParameterizedTest
    @CsvSource({"max,max", "MAX,max", "1,1", "0.5,0.5", "20.0,20", "100,100", "8x,8"})
    void readsAndWritesTheSameSpeed(String text, String written) {
        Speed speed = Speed.parse(text);

        assertThat(speed).hasToString(written);
        assertThat(Speed.parse(speed.toString())).isEqualTo(speed);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-1", "fast", "", "NaN", "Infinity"})
    void saysWhatIsAllowed(String text) {
        assertThatThrownBy(() -> Speed.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'max'")
                .hasMessageContaining("'" + text + "'");
    }

    @Test
    void onlyMaxWaitsForNothing() {
        assertThat(Speed.MAX.isMax()).isTrue();
        assertThat(Speed.REAL.isMax()).isFalse();
    }
}
