package org.sami.boat.server;

/** Sets the motors as the commander says, as long as it says so. */
final class HandDrive {
    private final SteeringControl steering;
    private final long deadmanMs;
    private double thrust;
    private double rudder;
    private long setMs;

    /**
     * A drive by hand.
     *
     * @param deadmanMs how long one setting holds
     */
    HandDrive(SteeringControl steering, long deadmanMs) {
        this.steering = steering;
        this.deadmanMs = deadmanMs;
    }

    void set(double newThrust, double newRudder, long nowMs) {
        thrust = newThrust;
        rudder = newRudder;
        setMs = nowMs;
    }

    /** Whether the last setting holds no longer. */
    boolean isSilent(long nowMs) {
        return nowMs - setMs >= deadmanMs;
    }

    void tick() {
        steering.drive(thrust, rudder);
    }
}
