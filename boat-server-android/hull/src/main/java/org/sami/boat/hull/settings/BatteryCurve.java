package org.sami.boat.hull.settings;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** The charge of a battery pack by its voltage at rest: straight lines between points. Immutable. */
public final class BatteryCurve {
    /** Most points of a curve. */
    public static final int MAX_POINTS = 32;

    /** Highest voltage of a pack. */
    public static final double MAX_VOLTS = 60;

    private static final double[] LITHIUM_CELL = {3.27, 3.61, 3.69, 3.71, 3.75, 3.79, 3.84, 3.92, 4.02, 4.11, 4.20};
    private static final double[] IRON_PHOSPHATE_CELL = {
        2.50, 3.00, 3.20, 3.22, 3.25, 3.26, 3.27, 3.30, 3.32, 3.35, 3.40
    };
    private static final double[] NICKEL_CELL = {1.00, 1.15, 1.20, 1.22, 1.235, 1.245, 1.255, 1.265, 1.28, 1.31, 1.38};
    private static final double[] LEAD_CELL = {
        1.75, 1.885, 1.918, 1.952, 1.977, 2.003, 2.028, 2.053, 2.077, 2.102, 2.122
    };
    private static final Map<String, BatteryCurve> KNOWN = known();

    private final double[] volts;
    private final double[] percents;

    /**
     * A curve through points.
     *
     * @param volts rising, above 0 and at most {@link #MAX_VOLTS}
     * @param percents rising or equal, from 0 to 100
     */
    public BatteryCurve(double[] volts, double[] percents) {
        this.volts = volts.clone();
        this.percents = percents.clone();
        if (volts.length < 2 || volts.length > MAX_POINTS || volts.length != percents.length) {
            throw new IllegalArgumentException("a battery has 2 to " + MAX_POINTS + " volts and as many percents, not "
                    + volts.length + " and " + percents.length);
        }
        for (int i = 0; i < volts.length; i++) {
            if (!(volts[i] > 0 && volts[i] <= MAX_VOLTS && percents[i] >= 0 && percents[i] <= 100)) {
                throw new IllegalArgumentException("no point of a battery: " + volts[i] + " V, " + percents[i] + " %");
            }
            if (i > 0 && !(volts[i] > volts[i - 1] && percents[i] >= percents[i - 1])) {
                throw new IllegalArgumentException(
                        "volts and percents rise: " + volts[i] + " V, " + percents[i] + " %");
            }
        }
    }

    /** The packs with a name, and their curves. */
    public static Map<String, BatteryCurve> named() {
        return KNOWN;
    }

    private static Map<String, BatteryCurve> known() {
        Map<String, BatteryCurve> all = new LinkedHashMap<>();
        all.put("lipo-3s", cells(LITHIUM_CELL, 3));
        all.put("lipo-4s", cells(LITHIUM_CELL, 4));
        all.put("lifepo4-4s", cells(IRON_PHOSPHATE_CELL, 4));
        all.put("nimh-10", cells(NICKEL_CELL, 10));
        all.put("lead-12v", cells(LEAD_CELL, 6));
        return Collections.unmodifiableMap(all);
    }

    private static BatteryCurve cells(double[] cell, int count) {
        double[] volts = new double[cell.length];
        double[] percents = new double[cell.length];
        for (int i = 0; i < cell.length; i++) {
            volts[i] = cell[i] * count;
            percents[i] = 100.0 * i / (cell.length - 1);
        }
        return new BatteryCurve(volts, percents);
    }

    /** Charge in percent at a voltage. */
    public double percent(double atVolts) {
        if (!(atVolts > volts[0])) {
            return percents[0];
        }
        int i = 1;
        while (i < volts.length - 1 && atVolts > volts[i]) {
            i++;
        }
        double part = Math.min(1, (atVolts - volts[i - 1]) / (volts[i] - volts[i - 1]));
        return percents[i - 1] + part * (percents[i] - percents[i - 1]);
    }

    /** Voltage at rest at a charge in percent: the lowest that has it. */
    public double voltsAt(double percent) {
        int i = 1;
        while (i < volts.length - 1 && percent > percents[i]) {
            i++;
        }
        double span = percents[i] - percents[i - 1];
        double part = span > 0 ? (percent - percents[i - 1]) / span : 0;
        return volts[i - 1] + Math.max(0, Math.min(1, part)) * (volts[i] - volts[i - 1]);
    }

    /** Its voltages, rising. */
    public double[] volts() {
        return volts.clone();
    }

    /** Its charges in percent, one for each voltage. */
    public double[] percents() {
        return percents.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof BatteryCurve
                && Arrays.equals(volts, ((BatteryCurve) other).volts)
                && Arrays.equals(percents, ((BatteryCurve) other).percents);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(volts) + Arrays.hashCode(percents);
    }

    @Override
    public String toString() {
        return volts[0] + " to " + volts[volts.length - 1] + " V";
    }
}
