package org.sami.mavlink.mission;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** When an item that was read back is the one that was sent. */
class MissionItemTest {
    @ParameterizedTest
    @CsvSource({"0, 5, true", "3, 6, true", "10, 11, true", "0, 3, false", "3, 10, false", "6, 11, false"})
    void anItemIsTheSameInBothFormsOfItsFrameAndInNoOther(int sent, int held, boolean same) {
        assertThat(item(sent).isSameAs(item(held))).isEqualTo(same);
        assertThat(item(held).isSameAs(item(sent))).isEqualTo(same);
    }

    private static MissionItem item(int frame) {
        return new MissionItem(1, 16, frame, 45.5, 10.7, 20, 0, 0, 0, 0);
    }
}
