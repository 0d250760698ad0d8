package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.server.vehicle.PlaneMath;

class PlaneMathTest {
    @Test
    void turnsAreTheSameToTheLastBitAsByTheExactRemainder() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 20_000; i++) {
            double rad = random.nextDouble(-20, 20);

            assertThat(PlaneMath.sameTurn(rad)).as("%s", rad).isEqualTo(Math.IEEEremainder(rad, 2 * Math.PI));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, Math.PI, -Math.PI, 3 * Math.PI, -3 * Math.PI, 2 * Math.PI, 1e300, Double.NaN})
    void turnsAreInOneHalfTurnEitherWay(double rad) {
        double same = PlaneMath.sameTurn(rad);

        assertThat(Math.abs(same) <= Math.PI || Double.isNaN(rad)).isTrue();
        assertThat(StrictMath.sin(same)).isCloseTo(StrictMath.sin(rad), within(Math.abs(rad) > 100 ? 2 : 1e-12));
    }

    @Test
    void lengthsAgreeWithTheGuardedOnes() {
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 1000; i++) {
            double east = random.nextDouble(-2000, 2000);
            double north = random.nextDouble(-1e-3, 1e-3);

            assertThat(PlaneMath.length(east, north)).isCloseTo(Math.hypot(east, north), within(1e-12));
        }
    }
}
