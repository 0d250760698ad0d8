package org.sami.crw.sim.hull;

import java.util.SplittableRandom;

/** When a receiver like {@link Receiver#LOGGED} has a new position, and how far its compass is off for its age. */
final class LoggedFixes {
    private static final double SHORTEST_S = 1;
    private static final double LONGEST_S = 2;
    private static final double LONGEST_FREEZE_S = 18;
    private static final double FREEZE_PART = 1 / 60.0;
    private static final double SETTLING_S = 10; // of either offset of the compass
    private static final double FIRST_OFF_DEG = 130;
    private static final double THEN_OFF_DEG = 62;

    private final SplittableRandom random;
    private final int side; // to which the compass is off: 1 or -1
    private double ageS;
    private double waitsS; // until the next position

    LoggedFixes(SplittableRandom random) {
        this.random = random;
        side = random.nextBoolean() ? 1 : -1;
    }

    /** Lets time pass; whether there is a new position at its end. */
    boolean step(double seconds) {
        ageS += seconds;
        waitsS -= seconds;
        if (waitsS > 0) {
            return false;
        }
        double mostS = random.nextDouble() < FREEZE_PART ? LONGEST_FREEZE_S : LONGEST_S;
        waitsS = SHORTEST_S + (mostS - SHORTEST_S) * random.nextDouble();
        return true;
    }

    /** By how much the compass turns the heading, in radians, clockwise. */
    double compassOffRad() {
        if (ageS >= 2 * SETTLING_S) {
            return 0;
        }
        return side * Math.toRadians(ageS < SETTLING_S ? FIRST_OFF_DEG : THEN_OFF_DEG);
    }
}
