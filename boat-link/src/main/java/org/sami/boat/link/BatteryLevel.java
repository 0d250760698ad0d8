package org.sami.boat.link;

/** The class of a battery's charge: nominal ≥ low threshold &gt; low ≥ critical threshold &gt; critical. */
public enum BatteryLevel {
    /** Enough. */
    NOMINAL,
    /** Below the low threshold. */
    LOW,
    /** Below the critical threshold. */
    CRITICAL;

    /** The class of a charge, for thresholds in the same unit. */
    public static BatteryLevel of(double percent, double lowPercent, double criticalPercent) {
        if (percent >= lowPercent) {
            return NOMINAL;
        }
        return percent >= criticalPercent ? LOW : CRITICAL;
    }
}
