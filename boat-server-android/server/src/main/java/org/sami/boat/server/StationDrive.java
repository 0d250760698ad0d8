package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.server.traffic.Course;
import org.sami.boat.server.traffic.CourseAndSpeed;
import org.sami.boat.server.traffic.GivingWay;
import org.sami.boat.server.traffic.LineAhead;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/** Drives a boat that keeps a station back to it, or aside, but for others. For the thread that ticks the server. */
final class StationDrive {
    /** Until a boat that lies still and has no room to move looks for room again: it has time, and many lie near others for long. */
    private static final long STANDS_MS = 500;

    private static final double STILL_MPS = 0.05; // with more, current or wind carry it to where there may be room

    private final Vehicle vehicle;
    private final SteeringControl steering;
    private final GivingWay givingWay;
    private Optional<Standing> standing = Optional.empty();

    /** That the boat lies still without room to move, since a time. */
    private static final class Standing {
        private final double courseRad;
        private final long sinceMs;

        Standing(double courseRad, long sinceMs) {
            this.courseRad = courseRad;
            this.sinceMs = sinceMs;
        }
    }

    StationDrive(Vehicle vehicle, SteeringControl steering, GivingWay givingWay) {
        this.vehicle = vehicle;
        this.steering = steering;
        this.givingWay = givingWay;
    }

    /** From now on the boat keeps another station. */
    void begin() {
        standing = Optional.empty();
    }

    /** Drives straight to a target for one tick; rests as long as the vehicle does not know where it is or what it does. */
    void drive(LocalFrame to, double speedMps, long nowMs, double seconds) {
        double courseRad = steering.courseRad(to);
        if (Double.isNaN(courseRad + vehicle.headingRad() + vehicle.speedMps())) {
            steering.rest();
            return;
        }
        long stoodMs = standing.map(since -> nowMs - since.sinceMs).orElse(0L);
        if (standing.isPresent() && stoodMs < STANDS_MS) {
            steering.steerAlong(standing.get().courseRad, 0, seconds);
            return;
        }
        CourseAndSpeed chosen = givingWay.choose(
                new CourseAndSpeed(courseRad, speedMps),
                new Course(vehicle.headingRad()),
                LineAhead.straight(courseRad, steering.distanceM(to)),
                false,
                nowMs,
                Math.max(seconds, stoodMs / 1000.0));
        boolean stands = chosen.speedMps() == 0 && Math.abs(vehicle.speedMps()) < STILL_MPS;
        standing = stands ? Optional.of(new Standing(chosen.courseRad(), nowMs)) : Optional.empty();
        steering.steerAlong(chosen.courseRad(), chosen.speedMps(), seconds);
    }
}
