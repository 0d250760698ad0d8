package org.sami.crw.sim.hull;

import java.util.SplittableRandom;

/**
 * How one quantity varies over the water: a mean, and in each cell of a grid of latitudes and longitudes one warm or cold patch
 * of its own place, size and height. Smooth, without end, and the same for all boats of one seed, in whatever process they are;
 * it does not change with time.
 */
public final class ScalarField {
    private static final double CELL_DEG = 0.002; // some 220 m northward
    private static final int REACH = 3; // cells; patches further away are below a thousandth
    private static final double LEAST_WIDTH = 0.3; // standard deviation of a patch, in cells
    private static final double MOST_WIDTH = 0.7;

    private final SensorKind kind;
    private final long seed;

    /** The field of a kind; other seeds give other fields. */
    public ScalarField(SensorKind kind, long seed) {
        this.kind = kind;
        this.seed = seed;
    }

    /** The value at a place, in the kind's unit. */
    public double at(double latDeg, double lonDeg) {
        double row = latDeg / CELL_DEG;
        double column = lonDeg / CELL_DEG;
        double sum = 0;
        for (long i = (long) Math.floor(row) - REACH; i <= Math.floor(row) + REACH; i++) {
            for (long j = (long) Math.floor(column) - REACH; j <= Math.floor(column) + REACH; j++) {
                sum += patch(i, j, row, column);
            }
        }
        return kind.mean() + kind.spread() * sum;
    }

    private double patch(long i, long j, double row, double column) {
        SplittableRandom random = new SplittableRandom(seed * 0x9e3779b97f4a7c15L
                + i * 0xc2b2ae3d27d4eb4fL
                + j * 0x165667b19e3779f9L
                + kind.word().hashCode());
        double height = random.nextDouble(-0.5, 0.5);
        double north = row - i - random.nextDouble();
        double east = column - j - random.nextDouble();
        double width = random.nextDouble(LEAST_WIDTH, MOST_WIDTH);
        return height * StrictMath.exp(-(north * north + east * east) / (2 * width * width));
    }
}
