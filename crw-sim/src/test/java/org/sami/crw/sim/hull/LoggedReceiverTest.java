package org.sami.crw.sim.hull;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;

/** The conditions "logged" against what the boats' logs show of a boat that lies still. */
class LoggedReceiverTest {
    private static final LocalFrame FRAME = new LocalFrame(45.7, 10.72);
    private static final int WINDOW = 57; // seconds, as in the log

    private static Instruments instruments(long seed) {
        SimulatedHull hull = new SimulatedHull(HullConfig.DEFAULT, Conditions.CALM, FRAME, 0, 0, 1);
        return new Instruments(hull, Conditions.LOGGED, seed, 1);
    }

    /** North of the truth, once a second. */
    private static double[] northM(Instruments instruments, int seconds) {
        double[] values = new double[seconds];
        for (int i = 0; i < seconds; i++) {
            for (int tick = 0; tick < 10; tick++) {
                instruments.step(0.1);
            }
            values[i] = FRAME.northM(instruments.latDeg(), instruments.lonDeg());
        }
        return values;
    }

    @Test
    void positionsWanderWithinAMinuteAsInTheLog() {
        int windows = 300;
        double[] values = northM(instruments(3), windows * WINDOW);
        double deviations = 0;
        double extents = 0;
        for (int w = 0; w < windows; w++) {
            double[] part = Arrays.copyOfRange(values, w * WINDOW, (w + 1) * WINDOW);
            double mean = Arrays.stream(part).average().orElseThrow();
            deviations += Math.sqrt(Arrays.stream(part)
                    .map(one -> (one - mean) * (one - mean))
                    .average()
                    .orElseThrow());
            extents += Arrays.stream(part).max().orElseThrow()
                    - Arrays.stream(part).min().orElseThrow();
        }

        assertThat(deviations / windows).as("the log: 1.4 m").isCloseTo(1.4, within(0.2));
        assertThat(extents / windows).as("the log: 6.5 m and 7 m").isBetween(5.0, 7.5);
    }

    @Test
    void positionsComeEverySecondOrTwoAndStayAwayNowAndThen() {
        Instruments instruments = instruments(3);
        double before = Double.NaN;
        double sinceS = 0;
        double longestS = 0;
        int count = 0;
        for (int tick = 0; tick < 100_000; tick++) {
            instruments.step(0.1);
            sinceS += 0.1;
            if (instruments.latDeg() != before) {
                before = instruments.latDeg();
                longestS = Math.max(longestS, sinceS);
                sinceS = 0;
                count++;
            }
        }

        assertThat(10_000.0 / count).as("seconds from one to the next").isBetween(1.4, 1.9);
        assertThat(longestS).isBetween(12.0, 18.2);
    }

    @Test
    void compassIsOffAtFirst() {
        Instruments instruments = instruments(3);
        instruments.step(5);
        assertThat(Math.abs(Math.toDegrees(instruments.headingRad()))).isCloseTo(130, within(25.0));
        instruments.step(10);
        assertThat(Math.abs(Math.toDegrees(instruments.headingRad()))).isCloseTo(62, within(25.0));
        instruments.step(10);
        assertThat(Math.abs(Math.toDegrees(instruments.headingRad()))).isLessThan(25);
    }

    @Test
    void journalKeepsTheReceiverAndOthersHaveNone() {
        assertThat(Conditions.fromMap(Conditions.LOGGED.toMap())).isEqualTo(Conditions.LOGGED);
        assertThat(List.of(Conditions.CALM, Conditions.FIELD, Conditions.ROUGH))
                .allSatisfy(water -> assertThat(water.toMap()).doesNotContainKey("receiver"));
    }
}
