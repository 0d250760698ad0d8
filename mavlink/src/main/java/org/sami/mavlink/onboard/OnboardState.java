package org.sami.mavlink.onboard;

import java.util.Objects;
import java.util.Optional;

/**
 * How a vehicle is now, for what ground stations are sent.
 *
 * @param place where it is; empty where it does not know
 * @param home where it returns to; empty where it does not know
 * @param batteryPercent its charge, 0 to 100; empty where it does not know
 * @param batteryState how good the charge is
 * @param customMode the number of its mode
 * @param isArmed whether its motors may turn
 * @param isCritical whether a failsafe is at work
 * @param mission how far the mission is
 * @param fence whether it is where its fence lets it be
 */
public record OnboardState(
        Optional<Place> place,
        Optional<Place> home,
        Optional<Double> batteryPercent,
        BatteryState batteryState,
        long customMode,
        boolean isArmed,
        boolean isCritical,
        MissionProgress mission,
        FenceState fence) {
    /** How good a charge is. */
    public enum BatteryState {
        /** Enough. */
        OK,
        /** Little. */
        LOW,
        /** So little that it must return. */
        CRITICAL
    }

    /**
     * A place on the earth and the motion there.
     *
     * @param latDeg degrees north, WGS 84
     * @param lonDeg degrees east, WGS 84
     * @param headingRad radians clockwise from true north
     * @param speedMps metres a second along the heading; negative is astern
     */
    public record Place(double latDeg, double lonDeg, double headingRad, double speedMps) {}

    /**
     * How far the mission is.
     *
     * @param item the item that is carried out now or next
     * @param isUnderWay whether it is carried out now
     * @param isDone whether all items are done
     */
    public record MissionProgress(int item, boolean isUnderWay, boolean isDone) {}

    /**
     * Whether the vehicle is where its fence lets it be.
     *
     * @param isHeld whether it has a fence
     * @param isInForce whether it keeps to that now
     * @param isBreached whether it is outside
     * @param breaches how often it left the fence since its start
     * @param breachMs when it left the fence last, in ms of the clock by which it reports; 0 where it never did
     */
    public record FenceState(boolean isHeld, boolean isInForce, boolean isBreached, int breaches, long breachMs) {
        /** The state of a vehicle that never had a fence. */
        public static final FenceState NONE = new FenceState(false, false, false, 0, 0);
    }

    /** A state. */
    public OnboardState {
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(home, "home");
        Objects.requireNonNull(batteryPercent, "batteryPercent");
        Objects.requireNonNull(batteryState, "batteryState");
        Objects.requireNonNull(mission, "mission");
        Objects.requireNonNull(fence, "fence");
    }
}
