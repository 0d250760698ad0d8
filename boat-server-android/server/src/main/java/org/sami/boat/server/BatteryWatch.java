package org.sami.boat.server;

import org.sami.boat.link.BatteryLevel;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Finds the class of the charge: by its thresholds, and critical as well where the charge lasts just for the way home from here. Who turned
 * critical for the way stays so until the battery is charged, or it would be uncritical again as soon as it has turned round.
 */
final class BatteryWatch {
    /** So many times the way home: a tenth for a metre that costs more than the mean, a quarter for a current, or a detour that is not known. */
    static final double RESERVE = 1.4;

    /** A charge that rises by so much, in percent of full, did not do so by itself. */
    private static final double CHARGED_PERCENT = 5;

    private static final long LOOK_MS = 1000;

    private final ServerConfig config;
    private final Vehicle vehicle;
    private final WaysHome ways;
    private long lookedMs = Long.MIN_VALUE / 2;
    private double neededPercent; // for the way home; not a number where the vehicle does not know where it is
    private double turnedAtPercent = Double.NaN; // while it is critical for the way

    BatteryWatch(ServerConfig config, Vehicle vehicle, WaysHome ways) {
        this.config = config;
        this.vehicle = vehicle;
        this.ways = ways;
    }

    /** Lets time pass; the way home is measured once a second. */
    void tick(long nowMs) {
        if (config.metresPerPercent() > 0 && nowMs - lookedMs >= LOOK_MS) {
            lookedMs = nowMs;
            neededPercent = RESERVE * ways.lengthM(vehicle.latDeg(), vehicle.lonDeg()) / config.metresPerPercent();
            look(vehicle.batteryPercent());
        }
    }

    private void look(double percent) {
        if (percent >= turnedAtPercent + CHARGED_PERCENT) {
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
