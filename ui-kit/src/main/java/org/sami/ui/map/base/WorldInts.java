package org.sami.ui.map.base;

/** The unit square of the world in ints, 2^32 wide: a step is 9 mm at the equator, a quarter of a pixel of the finest scale. */
final class WorldInts {
    private static final double STEPS = 4294967296.0;
    private static final double HALF = STEPS / 2;

    private WorldInts() {}

    static int of(double unit) {
        return (int) Math.max(-HALF, Math.min(HALF - 1, Math.rint(unit * STEPS - HALF)));
    }

    static double unit(int steps) {
        return (steps + HALF) / STEPS;
    }

    /** How many steps a pixel is where the world is so many pixels wide. */
    static double stepsPerPx(double worldPx) {
        return STEPS / worldPx;
    }
}
