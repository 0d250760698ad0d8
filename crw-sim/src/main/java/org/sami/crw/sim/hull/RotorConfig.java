package org.sami.crw.sim.hull;

/**
 * Vertical speeds, ceiling and consumption of a simulated copter. Immutable.
 *
 * @param climbMps speed up in m/s
 * @param descentMps speed down in m/s
 * @param ceilingM it climbs no higher than this, in metres above its take-off
 * @param batteryPercentPerS charge in percent that a second in the air costs
 */
public record RotorConfig(double climbMps, double descentMps, double ceilingM, double batteryPercentPerS) {
    /** A copter of 2 kg that stays 25 minutes in the air; the ceiling is the legal one for small aircraft in Europe. */
    public static final RotorConfig DEFAULT = new RotorConfig(3, 2, 120, 100.0 / (25 * 60));

    /** Refuses speeds and ceilings that are not positive, and a battery that fills in the air. */
    public RotorConfig {
        if (!(climbMps > 0 && descentMps > 0 && ceilingM > 0 && batteryPercentPerS >= 0)) {
            throw new IllegalArgumentException("a copter climbs " + climbMps + " m/s, descends " + descentMps
                    + " m/s, up to " + ceilingM + " m, on " + batteryPercentPerS + " % of charge a second");
        }
    }
}
