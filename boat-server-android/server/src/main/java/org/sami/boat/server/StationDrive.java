package org.sami.boat.server;

import org.sami.boat.server.traffic.CourseAndSpeed;
import org.sami.boat.server.traffic.CourseVector;
import org.sami.boat.server.traffic.GivingWay;
import org.sami.boat.server.traffic.LineAhead;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/** Drives a boat that keeps a station back to it, or aside, and gives way to others meanwhile. For the thread that ticks the server. */
final class StationDrive {
    /** How long a boat that lies still without room waits before it looks for room again: boats near others lie still for long. */
    private static final long RETRY_MS = 500;

    private static final double STILL_MPS = 0.05; // faster, current or wind carry it to where there may be room

    private final Vehicle vehicle;
    private final SteeringControl steering;
    private final GivingWay givingWay;
    private boolean stands; // lies still without room to move
    private double standsRad; // its course then
    private long standsSinceMs;

    StationDrive(Vehicle vehicle, SteeringControl steering, GivingWay givingWay) {
        this.vehicle = vehicle;
        this.steering = steering;
        this.givingWay = givingWay;
    }

    /** The boat keeps another station from now on. */
    void begin() {
        stands = false;
    }

    /** Drives straight to a target for one tick; rests while the vehicle does not know its position, heading or speed. */
    void drive(LocalFrame to, double speedMps, long nowMs, double seconds) {
        double courseRad = steering.courseRad(to);
        if (Double.isNaN(courseRad + vehicle.headingRad() + vehicle.speedMps())) {
            steering.rest();
            return;
        }
        long stoodMs = stands ? nowMs - standsSinceMs : 0;
        if (stands && stoodMs < RETRY_MS) {
            steering.steerAlong(standsRad, 0, seconds);
            return;
        }
        CourseAndSpeed chosen = givingWay.choose(
                new CourseAndSpeed(courseRad, speedMps),
                new CourseVector(vehicle.headingRad()),
                LineAhead.straight(courseRad, steering.distanceM(to)),
                false,
                nowMs,
                Math.max(seconds, stoodMs / 1000.0));
        stands = chosen.speedMps() == 0 && Math.abs(vehicle.speedMps()) < STILL_MPS;
        standsRad = chosen.courseRad();
        standsSinceMs = nowMs;
        steering.steerAlong(chosen.courseRad(), chosen.speedMps(), seconds);
    }
}
