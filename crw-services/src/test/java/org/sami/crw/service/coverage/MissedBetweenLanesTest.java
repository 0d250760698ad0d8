package org.sami.crw.service.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MissedBetweenLanesTest {
    /** Lanes whose errors are drawn; what is left between them is summed up. */
    @ParameterizedTest
    @CsvSource({"2, 5, 5", "2, 10, 10", "1.4, 9, 10", "1.4, 40, 50", "2, 5, 10"})
    void agreesWithLanesWhoseErrorsAreDrawn(double positionM, double laneM, double spacingM) {
        Random random = new Random(3);
        int lanes = 200_000;
        double leftM = 0;
        double beforeM = positionM * random.nextGaussian();
        for (int lane = 1; lane <= lanes; lane++) {
            double nextM = positionM * random.nextGaussian();
            leftM += Math.max(0, nextM - beforeM - (spacingM - laneM));
            beforeM = nextM;
        }

        assertThat(MissedBetweenLanes.share(positionM, laneM, spacingM))
                .isCloseTo(leftM / (lanes * laneM), within(0.002));
    }

    @Test
    void nothingIsSaidWhereNextToNothingIsMissed() {
        assertThat(MissedBetweenLanes.words(0, 5, 5)).isEmpty();
        assertThat(MissedBetweenLanes.words(0.4, 50, 50)).isEmpty();
        assertThat(MissedBetweenLanes.words(2, 5, 5))
                .isEqualTo("; as positions err by 2.0 m, about 23 % are likely missed between the lanes unseen");
    }
}
