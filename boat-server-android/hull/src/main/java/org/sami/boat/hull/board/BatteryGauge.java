package org.sami.boat.hull.board;

import org.sami.boat.hull.settings.BatteryCurve;

/**
 * The charge of the battery by its voltage. Thrust pulls the voltage down for seconds, so the charge follows a mean over {@link #MEAN_S}; a swapped battery,
 * half a volt or more above it for three reports in a row, counts at once. Safe for use by several threads.
 */
final class BatteryGauge {
    /** Reports come once a second. */
    private static final double MEAN_S = 20;

    private static final double SWAP_VOLTS = 0.5;
    private static final int SWAP_REPORTS = 3;

    private double volts = Double.NaN;
    private int above;

    /** Takes a voltage; whether it makes sense. */
    synchronized boolean take(double next) {
        if (!(next > 0 && next <= BatteryCurve.MAX_VOLTS)) {
            return false;
        }
        above = next > volts + SWAP_VOLTS ? above + 1 : 0;
        if (Double.isNaN(volts) || above >= SWAP_REPORTS) {
            volts = next;
            above = 0;
        } else {
            volts += (next - volts) / MEAN_S;
        }
        return true;
    }

    /** Mean voltage; NaN before the first. */
    synchronized double volts() {
        return volts;
    }

    /** Charge in percent; 0 before the first voltage, as nothing may look well that is not known. */
    synchronized double percent(BatteryCurve curve) {
        return Double.isNaN(volts) ? 0 : curve.percent(volts);
    }
}
