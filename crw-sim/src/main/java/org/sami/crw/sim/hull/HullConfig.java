package org.sami.crw.sim.hull;

import org.sami.boat.server.BoatDefaults;
import org.sami.boat.server.ServerConfig;
import org.sami.crw.service.reach.Range;

/**
 * What a simulated hull can do.
 *
 * @param topSpeedMps speed ahead at full thrust in m/s; at least twice the cruise speed of 1.5 m/s by default
 * @param maxAccelerationMps2 most that the speed changes, in m/s per second, either way
 * @param maxTurnRateRadPerS turn rate at full opposite thrust, in radians a second
 * @param maxTurnAccelerationRadPerS2 most that the turn rate changes, in radians a second per second
 * @param batteryPercentPerM the constant K of thesis 7.1.1: charge in percent that one metre costs on the average
 */
public record HullConfig(
        double topSpeedMps,
        double maxAccelerationMps2,
        double maxTurnRateRadPerS,
        double maxTurnAccelerationRadPerS2,
        double batteryPercentPerM) {

    /** A boat of the fleet: 3.2 m/s, and about 3.5 km on one battery. */
    public static final HullConfig DEFAULT =
            new HullConfig(BoatDefaults.FULL_THRUST_SPEED_MPS, 0.6, 0.9, 2.0, 1 / Range.METRES_PER_PERCENT);

    /** Refuses limits that are not positive; a battery that never drains (0) is allowed. */
    public HullConfig {
        positive("top speed", topSpeedMps);
        positive("acceleration", maxAccelerationMps2);
        positive("turn rate", maxTurnRateRadPerS);
        positive("turn acceleration", maxTurnAccelerationRadPerS2);
        if (!(batteryPercentPerM >= 0 && Double.isFinite(batteryPercentPerM))) {
            throw new IllegalArgumentException("battery drain per metre: " + batteryPercentPerM);
        }
    }

    /** The same hull with another battery constant. */
    public HullConfig withBatteryPercentPerM(double percentPerM) {
        return new HullConfig(
                topSpeedMps, maxAccelerationMps2, maxTurnRateRadPerS, maxTurnAccelerationRadPerS2, percentPerM);
    }

    /** The same hull with other motors. */
    public HullConfig withTopSpeedMps(double mps) {
        return new HullConfig(
                mps, maxAccelerationMps2, maxTurnRateRadPerS, maxTurnAccelerationRadPerS2, batteryPercentPerM);
    }

    /** What a boat server on it knows of it. */
    public ServerConfig.Builder describeTo(ServerConfig.Builder server) {
        ServerConfig.Builder told = server.fullThrustSpeedMps(topSpeedMps);
        return batteryPercentPerM > 0 ? told.metresPerPercent(1 / batteryPercentPerM) : told;
    }

    private static void positive(String name, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException("the " + name + " of a hull is positive, not " + value);
        }
    }
}
