package org.sami.ui.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TimeLineBarTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            0           | 1000
            167         | 1000
            1001        | 2000
            29000       | 30000
            31000       | 60000
            3600000     | 3600000
            90000000    | 172800000
            """)
    void timesStandAtFullStepsSoThatNoTwoAreEqual(long leastMillis, long stepMillis) {
        assertThat(TimeLineBar.step(leastMillis)).isEqualTo(stepMillis);
    }
}
