package org.sami.boat.server;

import org.sami.boat.link.BatteryDefaults;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Classifies the charge: by its thresholds, and as critical where it only just lasts for the way home. A boat that turned critical for its way home stays
 * critical until its battery is charged; otherwise it would be uncritical again as soon as it turns round.
 */
final class BatteryWatch {
    private static final long PERIOD_MS = 1000;

    private final ServerConfig config;
    private final Vehicle vehicle;
    private final WaysHome ways;
    private long lookedMs = Long.MIN_VALUE / 2;
    private double neededPercent; // for the way home; NaN while the vehicle does not know its position
    private double turnedAtPercent = Double.NaN; // while it is critical for the way

    BatteryWatch(ServerConfig config, Vehicle vehicle, WaysHome ways) {
        this.config = config;
        this.vehicle = vehicle;
        this.ways = ways;
    }

    /** Measures the way home once a second. */
    void tick(long nowMs) {
        if (config.metresPerPercent() > 0 && nowMs - lookedMs >= PERIOD_MS) {
            lookedMs = nowMs;
            neededPercent = BatteryDefaults.HOME_RESERVE_FACTOR
                    * ways.lengthM(vehicle.latDeg(), vehicle.lonDeg())
                    / config.metresPerPercent();
            look(vehicle.batteryPercent());
        }
    }

    private void look(double percent) {
        if (percent >= turnedAtPercent + BatteryDefaults.RECHARGED_PERCENT) {
            turnedAtPercent = Double.NaN;
        }
        if (Double.isNaN(turnedAtPercent) && percent < neededPercent) {
            turnedAtPercent = percent;
        }
    }

    BatteryLevel level() {
        return Double.isNaN(turnedAtPercent)
                ? BatteryLevel.of(vehicle.batteryPercent(), config.lowBatteryPercent(), config.criticalBatteryPercent())
                : BatteryLevel.CRITICAL;
    }
}
