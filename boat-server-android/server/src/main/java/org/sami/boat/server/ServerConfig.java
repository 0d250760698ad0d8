package org.sami.boat.server;

import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.BatteryDefaults;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.TrackingError;
import org.sami.boat.server.vehicle.LocalFrame;

/**
 * The configuration of one boat's server. Immutable; {@link Builder} refuses values out of range and names them. Everything holds until the server ends,
 * except the gains and the lost-link action, which commands can change.
 */
public final class ServerConfig {
    private final String boatId;
    private final String bootId;
    private final double fullThrustSpeedMps;
    private final double returnSpeedMps;
    private final double arrivalRadiusM;
    private final double holdRadiusM;
    private final Gains headingGains;
    private final Gains speedGains;
    private final long lostLinkAfterMs;
    private final LostLinkAction lostLinkAction;
    private final long deadmanMs;
    private final double telemetryHz;
    private final double lowBatteryPercent;
    private final double criticalBatteryPercent;
    private final BoatPerformance performance;
    private final int maxWaypoints;
    private final Optional<TrackingError> trackingError;
    private final Optional<LocalFrame> home;

    private ServerConfig(Builder builder) {
        boatId = builder.boatId;
        bootId = builder.bootId;
        fullThrustSpeedMps = builder.fullThrustSpeedMps;
        returnSpeedMps = builder.returnSpeedMps;
        arrivalRadiusM = builder.arrivalRadiusM;
        holdRadiusM = builder.holdRadiusM;
        headingGains = builder.headingGains;
        speedGains = builder.speedGains;
        lostLinkAfterMs = builder.lostLinkAfterMs;
        lostLinkAction = builder.lostLinkAction;
        deadmanMs = builder.deadmanMs;
        telemetryHz = builder.telemetryHz;
        lowBatteryPercent = builder.lowBatteryPercent;
        criticalBatteryPercent = builder.criticalBatteryPercent;
        performance = builder.performance;
        maxWaypoints = builder.maxWaypoints;
        trackingError = builder.trackingError;
        home = builder.home;
    }

    /** The defaults, for a boat and one start of its server. */
    public static Builder of(String boatId, String bootId) {
        return new Builder(boatId, bootId);
    }

    /** Names the boat; unique in the fleet. */
    public String boatId() {
        return boatId;
    }

    /** Names this start of the server; never used for another. */
    public String bootId() {
        return bootId;
    }

    /** Speed in m/s that full thrust gives in still water: the feed-forward of the speed loop. */
    public double fullThrustSpeedMps() {
        return fullThrustSpeedMps;
    }

    /** Speed in m/s of driving home and back to a station. */
    public double returnSpeedMps() {
        return returnSpeedMps;
    }

    /** Distance in metres at which a waypoint counts as reached once the boat has passed it, and at which home does. */
    public double arrivalRadiusM() {
        return arrivalRadiusM;
    }

    /** A boat on its station drifts up to this distance in metres before it drives back. */
    public double holdRadiusM() {
        return holdRadiusM;
    }

    /** Gains of the heading loop at the start. */
    public Gains headingGains() {
        return headingGains;
    }

    /** Gains of the speed loop at the start. */
    public Gains speedGains() {
        return speedGains;
    }

    /** The commander's link is lost after this time in ms without a frame. */
    public long lostLinkAfterMs() {
        return lostLinkAfterMs;
    }

    /** What the boat does when the link is lost, at the start. */
    public LostLinkAction lostLinkAction() {
        return lostLinkAction;
    }

    /** Teleoperation stops the motors after this time in ms without a new setting. */
    public long deadmanMs() {
        return deadmanMs;
    }

    /** Telemetry messages a second for a client that names no rate. */
    public double telemetryHz() {
        return telemetryHz;
    }

    /** Charge in percent below which the battery is low. */
    public double lowBatteryPercent() {
        return lowBatteryPercent;
    }

    /** Charge in percent below which the battery is critical. */
    public double criticalBatteryPercent() {
        return criticalBatteryPercent;
    }

    /** Mean distance on one percent of charge on the way home, in metres; 0 where unknown. */
    public double metresPerPercent() {
        return performance.metresPerPercent(returnSpeedMps).orElse(0);
    }

    /** What bases learn of how far, how fast and how narrowly the boat drives. */
    public BoatPerformance performance() {
        return performance;
    }

    /** The longest waypoint list that the boat takes. */
    public int maxWaypoints() {
        return maxWaypoints;
    }

    /** How far the boat may be off its path; empty where unknown. */
    public Optional<TrackingError> trackingError() {
        return trackingError;
    }

    /** Where the boat returns to; empty for where it is at the start of its server. */
    public Optional<LocalFrame> home() {
        return home;
    }

    /** Collects what differs from the defaults. */
    public static final class Builder {
        private final String boatId;
        private final String bootId;
        private double fullThrustSpeedMps = MotionDefaults.FULL_THRUST_SPEED_MPS;
        private double returnSpeedMps = MotionDefaults.CRUISE_SPEED_MPS;
        private double arrivalRadiusM = MotionDefaults.ARRIVAL_RADIUS_M;
        private double holdRadiusM = MotionDefaults.HOLD_RADIUS_M;
        private Gains headingGains = BoatServerDefaults.HEADING_GAINS;
        private Gains speedGains = BoatServerDefaults.SPEED_GAINS;
        private long lostLinkAfterMs = LinkDefaults.LINK_LOST_AFTER_MS;
        private LostLinkAction lostLinkAction = LinkDefaults.LOST_LINK_ACTION;
        private long deadmanMs = LinkDefaults.TELEOPERATION_STOP_MS;
        private double telemetryHz = LinkDefaults.TELEMETRY_HZ;
        private double lowBatteryPercent = BatteryDefaults.LOW_PERCENT;
        private double criticalBatteryPercent = BatteryDefaults.CRITICAL_PERCENT;
        private BoatPerformance performance = BoatPerformance.UNKNOWN;
        private int maxWaypoints = BoatServerDefaults.MAX_WAYPOINTS;
        private Optional<TrackingError> trackingError = Optional.empty();
        private Optional<LocalFrame> home = Optional.empty();

        private Builder(String boatId, String bootId) {
            this.boatId = named("boat id", boatId);
            this.bootId = named("boot id", bootId);
        }

        /** Speed in m/s that full thrust gives. */
        public Builder fullThrustSpeedMps(double value) {
            fullThrustSpeedMps = positive("full-thrust speed", value);
            return this;
        }

        /** Speed in m/s of driving home and back to a station. */
        public Builder returnSpeedMps(double value) {
            returnSpeedMps = positive("return speed", value);
            return this;
        }

        /** Distance in metres within which a boat may pass a waypoint. */
        public Builder arrivalRadiusM(double value) {
            arrivalRadiusM = positive("arrival radius", value);
            return this;
        }

        /** Distance in metres up to which a boat on its station drifts. */
        public Builder holdRadiusM(double value) {
            holdRadiusM = positive("hold radius", value);
            return this;
        }

        /** Gains of the heading loop. */
        public Builder headingGains(Gains value) {
            headingGains = Objects.requireNonNull(value, "heading gains");
            return this;
        }

        /** Gains of the speed loop. */
        public Builder speedGains(Gains value) {
            speedGains = Objects.requireNonNull(value, "speed gains");
            return this;
        }

        /** What the boat does when the link is lost. */
        public Builder lostLinkAction(LostLinkAction value) {
            lostLinkAction = Objects.requireNonNull(value, "lost-link action");
            return this;
        }

        /** Time in ms without a frame after which the link is lost. */
        public Builder lostLinkAfterMs(long value) {
            lostLinkAfterMs = positive("lost-link time", value);
            return this;
        }

        /** Time in ms after which teleoperation stops the motors. */
        public Builder deadmanMs(long value) {
            deadmanMs = positive("deadman time", value);
            return this;
        }

        /** Telemetry messages a second. */
        public Builder telemetryHz(double value) {
            telemetryHz = positive("telemetry rate", value);
            return this;
        }

        /** Thresholds of the battery's classes in percent, 0 ≤ critical ≤ low ≤ 100. */
        public Builder batteryThresholds(double lowPercent, double criticalPercent) {
            if (!(criticalPercent >= 0 && lowPercent >= criticalPercent && lowPercent <= 100)) {
                throw new IllegalArgumentException("battery thresholds " + lowPercent + " and " + criticalPercent);
            }
            lowBatteryPercent = lowPercent;
            criticalBatteryPercent = criticalPercent;
            return this;
        }

        /**
         * How far, how fast and how narrowly the boat drives: bases plan with it. If it says the distance on one percent of charge, the battery is also
         * critical when its charge only just lasts for the way home.
         */
        public Builder performance(BoatPerformance value) {
            performance = Objects.requireNonNull(value, "performance");
            return this;
        }

        /** The longest waypoint list. */
        public Builder maxWaypoints(int value) {
            maxWaypoints = (int) positive("waypoint limit", (long) value);
            return this;
        }

        /** How far the boat may be off its path: bases plan with it. */
        public Builder trackingError(TrackingError value) {
            trackingError = Optional.of(value);
            return this;
        }

        /** Where the boat returns to, as one that was begun again does: it may be anywhere by then. */
        public Builder home(double latDeg, double lonDeg) {
            home = Optional.of(new LocalFrame(latDeg, lonDeg));
            return this;
        }

        /** The finished configuration. */
        public ServerConfig build() {
            return new ServerConfig(this);
        }

        private static double positive(String name, double value) {
            if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException("the " + name + " is positive, not " + value);
            }
            return value;
        }

        private static long positive(String name, long value) {
            if (value <= 0) {
                throw new IllegalArgumentException("the " + name + " is positive, not " + value);
            }
            return value;
        }

        private static String named(String name, String value) {
            if (value.isEmpty()) {
                throw new IllegalArgumentException("the " + name + " is empty");
            }
            return value;
        }
    }
}
