package org.sami.crw.sim.run.world;

import org.sami.crw.sim.hull.HullConfig;

/**
 * When the batteries of boats in this process count as low and as critical (thesis 7.1.1): a boat that turns critical still comes
 * back to the quay from the farthest corner of its area, with a quarter to spare.
 *
 * @param lowPercent charge in percent below which a battery is no longer nominal
 * @param criticalPercent charge in percent below which it is critical
 */
record BatteryThresholds(double lowPercent, double criticalPercent) {
    private static final double RESERVE = 1.25;
    private static final double LEAST_PERCENT = 15;

    /** With more, a boat would turn critical before it gets to the farthest corner, and never arrive there. */
    private static final double MOST_PERCENT = 55;

    private static final double LOW_ABOVE_CRITICAL_PERCENT = 15;

    /** The thresholds for boats that are never farther from the quay than this, in metres. */
    static BatteryThresholds forWayBackM(double farthestM, HullConfig hull) {
        double needed = Math.ceil(RESERVE * farthestM * hull.batteryPercentPerM());
        double critical = Math.max(LEAST_PERCENT, Math.min(MOST_PERCENT, needed));
        return new BatteryThresholds(critical + LOW_ABOVE_CRITICAL_PERCENT, critical);
    }
}
