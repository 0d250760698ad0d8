package org.sami.boat.hull.settings;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.PowerCurve;

/**
 * How one hull is wired and how far its motors may go. Immutable; {@link Builder} refuses values out of range and names them.
 */
public final class HullSettings {
    /** Least safe maximum: with less a boat does not move. */
    public static final double LEAST_SAFE_MAXIMUM = 0.1;

    /** Largest trim, either way. */
    public static final double MAX_TRIM = 0.3;

    /** Largest thrust with which a rudder hull turns. */
    public static final double MAX_STEERING_THRUST = 0.5;

    /** Fastest turn of a hull in radians a second. */
    public static final double MAX_TURN_RATE = 3;

    /** Longest way for one percent of charge, in metres: 1000 km on one battery. */
    public static final double MAX_METRES_PER_PERCENT = 10_000;

    /** Fastest cruise speed in m/s. */
    public static final double MAX_CRUISE_MPS = 20;

    /** Largest turning radius in metres. */
    public static final double MAX_TURNING_RADIUS_M = 100;

    private final HullKind kind;
    private final double safeMaximum;
    private final double trim;
    private final boolean leftReversed;
    private final boolean rightReversed;
    private final boolean sidesSwapped;
    private final boolean rudderReversed;
    private final double steeringThrust;
    private final double turnRateRadPerS;
    private final String batteryName;
    private final BatteryCurve battery;
    private final boolean motorsChecked;
    private final BoatPerformance performance;

    private HullSettings(Builder from) {
        kind = from.kind;
        safeMaximum = from.safeMaximum;
        trim = from.trim;
        leftReversed = from.leftReversed;
        rightReversed = from.rightReversed;
        sidesSwapped = from.sidesSwapped;
        rudderReversed = from.rudderReversed;
        steeringThrust = from.steeringThrust;
        turnRateRadPerS = from.turnRateRadPerS;
        batteryName = from.batteryName;
        battery = from.battery;
        motorsChecked = from.motorsChecked;
        BoatPerformance driving = new BoatPerformance(from.metresPerPercent, from.cruiseMps, from.turningRadiusM);
        performance = from.power.map(driving::with).orElse(driving);
    }

    /** A hull of a kind with the defaults: 70 % of full thrust, nothing reversed but the rudder, a lithium pack of four cells. */
    public static Builder of(HullKind kind) {
        return new Builder(kind);
    }

    /** These, to be changed. */
    public Builder change() {
        Builder builder = new Builder(kind);
        builder.safeMaximum = safeMaximum;
        builder.trim = trim;
        builder.leftReversed = leftReversed;
        builder.rightReversed = rightReversed;
        builder.sidesSwapped = sidesSwapped;
        builder.rudderReversed = rudderReversed;
        builder.steeringThrust = steeringThrust;
        builder.turnRateRadPerS = turnRateRadPerS;
        builder.batteryName = batteryName;
        builder.battery = battery;
        builder.motorsChecked = motorsChecked;
        builder.metresPerPercent =
                performance.power().isPresent() ? OptionalDouble.empty() : performance.metresPerPercent();
        builder.power = performance.power();
        builder.cruiseMps = performance.cruiseMps();
        builder.turningRadiusM = performance.turningRadiusM();
        return builder;
    }

    /** How the hull is driven. */
    public HullKind kind() {
        return kind;
    }

    /** The part of full effort that the board is given at most, {@link #LEAST_SAFE_MAXIMUM} to 1: motor controllers restart at full thrust. */
    public double safeMaximum() {
        return safeMaximum;
    }

    /** Steering effort that keeps the hull straight, to starboard, -0.3 to 0.3: added to each one while the hull has thrust. */
    public double trim() {
        return trim;
    }

    /** Whether the left motor, or the only one, turns the wrong way. */
    public boolean leftReversed() {
        return leftReversed;
    }

    /** Whether the right motor turns the wrong way. */
    public boolean rightReversed() {
        return rightReversed;
    }

    /** Whether the board's first motor is the right one. */
    public boolean sidesSwapped() {
        return sidesSwapped;
    }

    /** Whether the rudder is mounted reversed, as it usually is. */
    public boolean rudderReversed() {
        return rudderReversed;
    }

    /** Thrust of a rudder hull with the rudder hard over, 0 to 0.5: without any, its rudder does not turn it. */
    public double steeringThrust() {
        return steeringThrust;
    }

    /** Turn rate at full steering effort in radians a second: the heading follows from it where there is neither compass nor gyro. */
    public double turnRateRadPerS() {
        return turnRateRadPerS;
    }

    /** Name of the battery pack; empty where its curve is given. */
    public String batteryName() {
        return batteryName;
    }

    /** Charge of the battery pack by its voltage. */
    public BatteryCurve battery() {
        return battery;
    }

    /** Whether somebody has gone through the {@link MotorCheck}. */
    public boolean motorsChecked() {
        return motorsChecked;
    }

    /** How far, how fast and how narrowly the hull drives, as far as somebody has measured it: bases plan with it. */
    public BoatPerformance performance() {
        return performance;
    }

    /** Collects what differs from the defaults. */
    public static final class Builder {
        private HullKind kind;
        private double safeMaximum = 0.7;
        private double trim;
        private boolean leftReversed;
        private boolean rightReversed;
        private boolean sidesSwapped;
        private boolean rudderReversed = true;
        private double steeringThrust = 0.25;
        private double turnRateRadPerS = 0.6;
        private String batteryName = "lipo-4s";
        private BatteryCurve battery = curve(batteryName);
        private boolean motorsChecked;
        private OptionalDouble metresPerPercent = OptionalDouble.empty();
        private Optional<PowerCurve> power = Optional.empty();
        private OptionalDouble cruiseMps = OptionalDouble.empty();
        private OptionalDouble turningRadiusM = OptionalDouble.empty();

        private Builder(HullKind kind) {
            this.kind = Objects.requireNonNull(kind, "kind");
        }

        /** How the hull is driven. */
        public Builder kind(HullKind value) {
            kind = Objects.requireNonNull(value, "kind");
            return this;
        }

        /** The part of full effort that the board is given at most. */
        public Builder safeMaximum(double value) {
            safeMaximum = within("safe maximum", value, LEAST_SAFE_MAXIMUM, 1);
            return this;
        }

        /** Steering effort to starboard that keeps the hull straight. */
        public Builder trim(double value) {
            trim = within("trim", value, -MAX_TRIM, MAX_TRIM);
            return this;
        }

        /** Whether the left motor, or the only one, turns the wrong way. */
        public Builder leftReversed(boolean value) {
            leftReversed = value;
            return this;
        }

        /** Whether the right motor turns the wrong way. */
        public Builder rightReversed(boolean value) {
            rightReversed = value;
            return this;
        }

        /** Whether the board's first motor is the right one. */
        public Builder sidesSwapped(boolean value) {
            sidesSwapped = value;
            return this;
        }

        /** Whether the rudder is mounted reversed. */
        public Builder rudderReversed(boolean value) {
            rudderReversed = value;
            return this;
        }

        /** Thrust of a rudder hull with the rudder hard over. */
        public Builder steeringThrust(double value) {
            steeringThrust = within("steering thrust", value, 0, MAX_STEERING_THRUST);
            return this;
        }

        /** Turn rate at full steering effort in radians a second. */
        public Builder turnRateRadPerS(double value) {
            turnRateRadPerS = within("turn rate", value, 0.05, MAX_TURN_RATE);
            return this;
        }

        /** A battery pack with a name. */
        public Builder battery(String name) {
            battery = curve(name);
            batteryName = name;
            return this;
        }

        /** A battery pack with a curve of its own. */
        public Builder battery(BatteryCurve value) {
            battery = Objects.requireNonNull(value, "battery");
            batteryName = "";
            return this;
        }

        /** Whether the motors were checked. */
        public Builder motorsChecked(boolean value) {
            motorsChecked = value;
            return this;
        }

        /** Mean distance on one percent of charge, in metres. */
        public Builder metresPerPercent(double value) {
            metresPerPercent =
                    OptionalDouble.of(within("way for a percent of charge", value, 0.1, MAX_METRES_PER_PERCENT));
            return this;
        }

        /** What the boat uses by its speed: how far a percent takes it follows from that. */
        public Builder power(PowerCurve value) {
            power = Optional.of(value);
            return this;
        }

        /** Speed on paths that name none, in m/s. */
        public Builder cruiseMps(double value) {
            cruiseMps = OptionalDouble.of(within("cruise speed", value, 0.1, MAX_CRUISE_MPS));
            return this;
        }

        /** Radius of the narrowest turn at that speed, in metres; 0 where the hull turns on the spot. */
        public Builder turningRadiusM(double value) {
            turningRadiusM = OptionalDouble.of(within("turning radius", value, 0, MAX_TURNING_RADIUS_M));
            return this;
        }

        /** The settings. */
        public HullSettings build() {
            if (power.isPresent() && metresPerPercent.isPresent()) {
                throw new IllegalArgumentException(
                        "/power: the way for a percent follows from it: no metresPerPercent");
            }
            return new HullSettings(this);
        }

        private static BatteryCurve curve(String name) {
            BatteryCurve known = BatteryCurve.named().get(name);
            if (known == null) {
                throw new IllegalArgumentException("there is no battery '" + name + "'; there are "
                        + String.join(", ", BatteryCurve.named().keySet()));
            }
            return known;
        }

        private static double within(String what, double value, double least, double most) {
            if (!(value >= least && value <= most)) {
                throw new IllegalArgumentException("the " + what + " is " + least + " to " + most + ", not " + value);
            }
            return value;
        }
    }
}
