package org.sami.crw.sim.hull;

import java.util.SplittableRandom;

/** A simulated hull's battery: its charge, and what of the mean consumption is drawn for each interval (thesis 7.1.1). */
final class SimulatedBattery {
    private static final double SPREAD = 0.1;

    private final SplittableRandom random;
    private final double intervalS;
    private double percent = 100;
    private double spread; // R of thesis 7.1.1
    private double spreadForS; // until it is drawn again

    /**
     * A full battery.
     *
     * @param intervalS for how long the cost of a metre stays the same, in seconds
     */
    SimulatedBattery(SplittableRandom random, double intervalS) {
        this.random = random;
        this.intervalS = intervalS;
    }

    /** Charge in percent of full. */
    double percent() {
        return percent;
    }

    void set(double newPercent) {
        percent = newPercent;
    }

    boolean isEmpty() {
        return percent <= 0;
    }

    /** Lets time pass for the interval. */
    void step(double seconds) {
        spreadForS -= seconds;
    }

    /** Takes a mean consumption in percent, and its spread. */
    void drain(double meanPercent) {
        if (spreadForS <= 0) {
            spread = random.nextDouble(-SPREAD, SPREAD);
            spreadForS = intervalS;
        }
        percent = Math.max(0, percent - meanPercent * (1 + spread));
    }
}
