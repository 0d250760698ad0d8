package org.sami.crw.sim.hull;

import java.util.SplittableRandom;

/**
 * A value that wanders about zero: a first-order Gauss-Markov process, the usual model of the error of a receiver that filters.
 * Its steps may be of any length without changing what it looks like. Equal seeds and steps give equal values to the last bit on
 * every machine.
 */
final class GaussMarkovError {
    private static final int UNIFORMS = 12; // their sum has a variance of 1

    private final double deviation;
    private final double correlationS;
    private final SplittableRandom random;
    private double value;
    private double stepS = Double.NaN; // the length of the last step, by which these two go
    private double left;
    private double fresh;

    /**
     * A value somewhere it might be.
     *
     * @param deviation its standard deviation; with 0 it stays zero
     * @param correlationS seconds after which a third of it is left
     */
    GaussMarkovError(double deviation, double correlationS, SplittableRandom random) {
        this.deviation = deviation;
        this.correlationS = correlationS;
        this.random = random;
        value = deviation * normal();
    }

    double value() {
        return value;
    }

    void step(double seconds) {
        if (deviation > 0) {
            if (seconds != stepS) {
                stepS = seconds;
                left = StrictMath.exp(-seconds / correlationS);
                fresh = deviation * Math.sqrt(1 - left * left);
            }
            value = value * left + fresh * normal();
        }
    }

    /** Nearly normal, never beyond six deviations. */
    private double normal() {
        double sum = -UNIFORMS / 2.0;
        for (int i = 0; i < UNIFORMS; i++) {
            sum += random.nextDouble();
        }
        return sum;
    }
}
