package org.sami.boat.hull.position;

import java.util.Arrays;

/**
 * Position and motion on a plane: a Kalman filter of five states, metres east and north, speed through the water along the heading, and the water's own
 * motion east and north. A heading that is known makes most of a turn predictable, so that the position need not follow each fix. Where no heading is known,
 * the motion of the water stands for all motion.
 */
final class TrackEstimate {
    private static final int EAST = 0;
    private static final int NORTH = 1;
    private static final int AHEAD = 2;
    private static final int FLOW_EAST = 3;
    private static final int FLOW_NORTH = 4;
    private static final int SIZE = 5;
    private static final double POSITION_WALK = 0.05; // m in a second
    private static final double SPEED_WALK = 0.5; // m/s in a second
    private static final double FLOW_WALK = 0.04; // m/s in a second
    private static final double FREE_WALK = 0.8; // m/s in a second, without a heading

    private final double[] x = new double[SIZE];
    private final double[][] p = new double[SIZE][SIZE];
    private final double[] row = new double[SIZE]; // of a measurement
    private final double[] ph = new double[SIZE];

    /** At rest at a place that is known so well. */
    TrackEstimate(double eastM, double northM, double errorM) {
        x[EAST] = eastM;
        x[NORTH] = northM;
        p[EAST][EAST] = errorM * errorM;
        p[NORTH][NORTH] = errorM * errorM;
        p[AHEAD][AHEAD] = 1;
        p[FLOW_EAST][FLOW_EAST] = 0.2 * 0.2;
        p[FLOW_NORTH][FLOW_NORTH] = 0.2 * 0.2;
    }

    double eastM() {
        return x[EAST];
    }

    double northM() {
        return x[NORTH];
    }

    /** Motion over ground to the east in m/s. */
    double eastMps(double headingRad) {
        return x[AHEAD] * Math.sin(headingRad) + x[FLOW_EAST];
    }

    /** Motion over ground to the north in m/s. */
    double northMps(double headingRad) {
        return x[AHEAD] * Math.cos(headingRad) + x[FLOW_NORTH];
    }

    /** Standard deviation along an axis in m. */
    double errorM() {
        return Math.sqrt((p[EAST][EAST] + p[NORTH][NORTH]) / 2);
    }

    /** Moves the origin of the plane. */
    void shift(double eastM, double northM) {
        x[EAST] += eastM;
        x[NORTH] += northM;
    }

    /**
     * Lets time pass.
     *
     * @param headingErrorRad its standard deviation; NaN where no heading is known
     */
    void pass(double headingRad, double headingErrorRad, double seconds) {
        double sin = Math.sin(headingRad);
        double cos = Math.cos(headingRad);
        x[EAST] += (x[AHEAD] * sin + x[FLOW_EAST]) * seconds;
        x[NORTH] += (x[AHEAD] * cos + x[FLOW_NORTH]) * seconds;
        add(EAST, AHEAD, sin * seconds, FLOW_EAST, seconds);
        add(NORTH, AHEAD, cos * seconds, FLOW_NORTH, seconds);
        boolean free = Double.isNaN(headingErrorRad);
        double sideways = free ? FREE_WALK : Math.hypot(FLOW_WALK, 0.3 * x[AHEAD] * Math.min(1, headingErrorRad));
        p[EAST][EAST] += POSITION_WALK * POSITION_WALK * seconds;
        p[NORTH][NORTH] += POSITION_WALK * POSITION_WALK * seconds;
        p[AHEAD][AHEAD] += free ? 0 : SPEED_WALK * SPEED_WALK * seconds;
        p[FLOW_EAST][FLOW_EAST] += sideways * sideways * seconds;
        p[FLOW_NORTH][FLOW_NORTH] += sideways * sideways * seconds;
    }

    /** P = F P F' where F adds parts of two states to one. */
    private void add(int to, int first, double firstPart, int second, double secondPart) {
        for (int i = 0; i < SIZE; i++) {
            p[to][i] += firstPart * p[first][i] + secondPart * p[second][i];
        }
        for (int i = 0; i < SIZE; i++) {
            p[i][to] += firstPart * p[i][first] + secondPart * p[i][second];
        }
    }

    /** How far a position is from the estimate, in standard deviations of both together. */
    double deviations(double eastM, double northM, double errorM) {
        double offM = Math.hypot(eastM - x[EAST], northM - x[NORTH]);
        return offM / Math.sqrt(errorM() * errorM() + errorM * errorM);
    }

    /** A position was measured. */
    void position(double eastM, double northM, double errorM) {
        Arrays.fill(row, 0);
        row[EAST] = 1;
        correct(eastM - x[EAST], errorM * errorM);
        row[EAST] = 0;
        row[NORTH] = 1;
        correct(northM - x[NORTH], errorM * errorM);
    }

    /** A motion over ground was measured. */
    void motion(double eastMps, double northMps, double headingRad, boolean headingKnown, double errorMps) {
        Arrays.fill(row, 0);
        row[AHEAD] = headingKnown ? Math.sin(headingRad) : 0;
        row[FLOW_EAST] = 1;
        correct(eastMps - row[AHEAD] * x[AHEAD] - x[FLOW_EAST], errorMps * errorMps);
        row[AHEAD] = headingKnown ? Math.cos(headingRad) : 0;
        row[FLOW_EAST] = 0;
        row[FLOW_NORTH] = 1;
        correct(northMps - row[AHEAD] * x[AHEAD] - x[FLOW_NORTH], errorMps * errorMps);
    }

    private void correct(double innovation, double variance) {
        double var = variance;
        for (int i = 0; i < SIZE; i++) {
            ph[i] = 0;
            for (int j = 0; j < SIZE; j++) {
                ph[i] += p[i][j] * row[j];
            }
        }
        for (int i = 0; i < SIZE; i++) {
            var += row[i] * ph[i];
        }
        for (int i = 0; i < SIZE; i++) {
            x[i] += ph[i] / var * innovation;
            for (int j = 0; j < SIZE; j++) {
                p[i][j] -= ph[i] * ph[j] / var;
            }
        }
        for (int i = 0; i < SIZE; i++) {
            p[i][i] = Math.max(1e-9, p[i][i]);
        }
    }
}
