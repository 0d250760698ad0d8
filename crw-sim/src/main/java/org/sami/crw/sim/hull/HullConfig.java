package org.sami.crw.sim.hull;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.PowerCurve;
import org.sami.boat.server.ServerConfig;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.service.reach.Endurance;
import org.sami.crw.service.reach.Range;

/**
 * What a simulated hull can do.
 *
 * @param topSpeedMps speed ahead at full thrust in m/s; at least twice the cruise speed of 1.5 m/s by default
 * @param maxAccelerationMps2 most that the speed changes, in m/s per second, either way
 * @param maxTurnRateRadPerS turn rate at full opposite thrust, in radians a second
 * @param maxTurnAccelerationRadPerS2 most that the turn rate changes, in radians a second per second
 * @param batteryPercentPerM the constant K of thesis 7.1.1: charge in percent that one metre costs on the average
 * @param rotors of a copter; empty for a boat
 * @param power what it uses by its speed, in place of the constant; empty where each metre costs the same
 */
public record HullConfig(
        double topSpeedMps,
        double maxAccelerationMps2,
        double maxTurnRateRadPerS,
        double maxTurnAccelerationRadPerS2,
        double batteryPercentPerM,
        Optional<RotorConfig> rotors,
        Optional<PowerCurve> power) {

    private static final double RETURN_MPS = 8; // this and the next two of a copter, which has to come home and land
    private static final double LOW_PERCENT = 35;
    private static final double CRITICAL_PERCENT = Endurance.LANDING_PERCENT;

    /** A boat of the fleet: 3.2 m/s, and about 3.5 km on one battery. */
    public static final HullConfig DEFAULT =
            new HullConfig(MotionDefaults.FULL_THRUST_SPEED_MPS, 0.6, 0.9, 2.0, 1 / Range.METRES_PER_PERCENT);

    /** A copter: 12 m/s, and 25 minutes in the air; distances cost nothing more. */
    public static final HullConfig COPTER =
            new HullConfig(12, 3, 1.5, 4, 0, Optional.of(RotorConfig.DEFAULT), Optional.empty());

    /** That of a kind of robots. */
    public static HullConfig of(RobotKind robots) {
        return robots == RobotKind.COPTER ? COPTER : DEFAULT;
    }

    /** A boat. */
    public HullConfig(
            double topSpeedMps,
            double maxAccelerationMps2,
            double maxTurnRateRadPerS,
            double maxTurnAccelerationRadPerS2,
            double batteryPercentPerM) {
        this(
                topSpeedMps,
                maxAccelerationMps2,
                maxTurnRateRadPerS,
                maxTurnAccelerationRadPerS2,
                batteryPercentPerM,
                Optional.empty(),
                Optional.empty());
    }

    /** Refuses limits that are not positive; a battery that never drains (0) is allowed. */
    public HullConfig {
        Objects.requireNonNull(rotors, "rotors");
        Objects.requireNonNull(power, "power");
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
                topSpeedMps,
                maxAccelerationMps2,
                maxTurnRateRadPerS,
                maxTurnAccelerationRadPerS2,
                percentPerM,
                rotors,
                power);
    }

    /** The same hull with a battery that lasts for so many metres on average when it is full. */
    public HullConfig withRangeM(double metres) {
        positive("range", metres);
        return withBatteryPercentPerM(100 / metres);
    }

    /** The same hull with other motors. */
    public HullConfig withTopSpeedMps(double mps) {
        return new HullConfig(
                mps,
                maxAccelerationMps2,
                maxTurnRateRadPerS,
                maxTurnAccelerationRadPerS2,
                batteryPercentPerM,
                rotors,
                power);
    }

    /** The same hull, whose consumption depends on its speed. */
    HullConfig withPower(PowerCurve curve) {
        return new HullConfig(
                topSpeedMps,
                maxAccelerationMps2,
                maxTurnRateRadPerS,
                maxTurnAccelerationRadPerS2,
                batteryPercentPerM,
                rotors,
                Optional.of(curve));
    }

    /** The same hull, which uses its battery so. */
    public HullConfig with(Energy energy) {
        return energy.power(batteryPercentPerM, cruiseMps())
                .map(this::withPower)
                .orElse(this);
    }

    private double cruiseMps() {
        return Math.min(MotionDefaults.CRUISE_SPEED_MPS, topSpeedMps);
    }

    /** What a boat server on it knows of it. */
    public ServerConfig.Builder describeTo(ServerConfig.Builder server) {
        ServerConfig.Builder told = server.fullThrustSpeedMps(topSpeedMps);
        return rotors.isPresent()
                ? told.returnSpeedMps(RETURN_MPS).batteryThresholds(LOW_PERCENT, CRITICAL_PERCENT)
                : told.performance(performance());
    }

    private BoatPerformance performance() {
        OptionalDouble cruise = OptionalDouble.of(cruiseMps());
        OptionalDouble turning = OptionalDouble.of(0); // opposite thrust turns it on the spot
        if (power.isPresent()) {
            return new BoatPerformance(OptionalDouble.empty(), cruise, turning).with(power.get());
        }
        return new BoatPerformance(
                batteryPercentPerM > 0 ? OptionalDouble.of(1 / batteryPercentPerM) : OptionalDouble.empty(),
                cruise,
                turning);
    }

    private static void positive(String name, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException("the " + name + " of a hull is positive, not " + value);
        }
    }
}
