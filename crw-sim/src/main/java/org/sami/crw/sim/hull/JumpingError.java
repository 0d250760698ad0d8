package org.sami.crw.sim.hull;

import java.util.SplittableRandom;

/**
 * Jumps of a position, as when a receiver loses a satellite: now and then it is off by up to so much in some direction, and comes back
 * within some seconds.
 */
final class JumpingError {
    private final double mostM;
    private final double fadingS;
    private final double meanIntervalS;
    private final SplittableRandom random;
    private double eastM;
    private double northM;

    /**
     * No jump yet.
     *
     * @param mostM the largest; with 0 it stays zero and nothing is drawn
     * @param fadingS seconds after which a third of a jump is left
     * @param meanIntervalS seconds from one jump to the next, on the average
     */
    JumpingError(double mostM, double fadingS, double meanIntervalS, SplittableRandom random) {
        this.mostM = mostM;
        this.fadingS = fadingS;
        this.meanIntervalS = meanIntervalS;
        this.random = random;
    }

    double eastM() {
        return eastM;
    }

    double northM() {
        return northM;
    }

    void step(double seconds) {
        if (mostM == 0) {
            return;
        }
        double left = StrictMath.exp(-seconds / fadingS);
        eastM *= left;
        northM *= left;
        if (random.nextDouble() < 1 - StrictMath.exp(-seconds / meanIntervalS)) {
            double sizeM = mostM * random.nextDouble();
            double directionRad = 2 * Math.PI * random.nextDouble();
            eastM = sizeM * StrictMath.sin(directionRad);
            northM = sizeM * StrictMath.cos(directionRad);
        }
    }
}
