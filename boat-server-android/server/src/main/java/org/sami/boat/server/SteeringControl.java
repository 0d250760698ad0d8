package org.sami.boat.server;

import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Steers the vehicle along a heading: heading by one loop, speed by feed-forward and another. Steering goes before
 * thrust, and the boat slows down while it points elsewhere, so that it turns on the spot rather than circle a target.
 *
 * <p>The integral of the speed loop is to learn what current and wear take, and nothing else: not that a boat needs time to get up to speed, nor that its
 * steering has taken the thrust. Of that, a boat that is to stand keeps what holds it back.
 */
final class SteeringControl {
    /** What a boat lacks more than that of its speed, it lacks because it needs time. */
    private static final double LEARNING_MPS = 0.6;

    private final Vehicle vehicle;
    private final double fullThrustSpeedMps;
    private final ControlLoop heading;
    private final ControlLoop speed;
    private boolean hadThrust = true; // that it was given last, all of it
    private boolean stands; // is to

    SteeringControl(Vehicle vehicle, ServerConfig config) {
        this.vehicle = vehicle;
        fullThrustSpeedMps = config.fullThrustSpeedMps();
        heading = new ControlLoop(config.headingGains());
        speed = new ControlLoop(config.speedGains());
    }

    /** The loop's gains from now on; it forgets the past. */
    void setGains(GainAxis axis, Gains gains) {
        loop(axis).setGains(gains);
    }

    Gains gains(GainAxis axis) {
        return loop(axis).gains();
    }

    private ControlLoop loop(GainAxis axis) {
        return axis == GainAxis.HEADING ? heading : speed;
    }

    /** Metres to a target, which is the origin of its frame. */
    double distanceM(LocalFrame target) {
        return target.distanceM(vehicle.latDeg(), vehicle.lonDeg());
    }

    /** Course in radians, clockwise from north, to a target; not a number as long as the vehicle does not know where it is. */
    double courseRad(LocalFrame target) {
        double eastM = target.eastM(vehicle.latDeg(), vehicle.lonDeg());
        double northM = target.northM(vehicle.latDeg(), vehicle.lonDeg());
        return StrictMath.atan2(-eastM, -northM);
    }

    /**
     * Steers a heading in radians, clockwise from north, for one tick; rests as long as the vehicle does not know where it is or what it
     * does.
     *
     * @param speedMps along that heading; 0 = it is to stand, as far as the motors can have it so
     */
    void steerAlong(double headingRad, double speedMps, double seconds) {
        steer(headingRad, speedMps, 0, seconds);
    }

    /**
     * Has the vehicle hold its place for one tick by heading against what carries it.
     *
     * @param headingRad against it, in radians
     * @param driftMps how fast it carries the vehicle, as far as that is known; what more it is, shows in the speed
     */
    void holdAgainst(double headingRad, double driftMps, double seconds) {
        steer(headingRad, 0, Math.max(0, driftMps - vehicle.speedMps()), seconds);
    }

    private void steer(double headingRad, double speedMps, double driftMps, double seconds) {
        double error = PlaneMath.sameTurn(headingRad - vehicle.headingRad());
        if (Double.isNaN(error + vehicle.speedMps())) {
            rest();
            return;
        }
        double ahead = Math.max(0, StrictMath.cos(error));
        double wantedMps = speedMps * ahead;
        double lackMps = wantedMps - vehicle.speedMps();
        if (speedMps == 0 && !stands) {
            speed.forgetWhatKeepsUp(lackMps);
        }
        stands = speedMps == 0;
        double learningS = hadThrust && Math.abs(lackMps) < LEARNING_MPS ? seconds : 0;
        double throughMps = wantedMps + driftMps * ahead;
        double thrust = throughMps / fullThrustSpeedMps + speed.effort(lackMps, learningS);
        drive(thrust, heading.effort(error, seconds));
    }

    /** Sets the motors for efforts ahead and to starboard; what both cannot have, steering gets. */
    void drive(double thrust, double rudder) {
        double room = 1 - Math.abs(rudder);
        double ahead = Math.max(-room, Math.min(room, thrust));
        hadThrust = ahead == thrust;
        vehicle.setMotors(ahead + rudder, ahead - rudder);
    }

    /** Motors to zero; the loops forget. */
    void rest() {
        vehicle.setMotors(0, 0);
        heading.reset();
        speed.reset();
        hadThrust = true;
        stands = false;
    }
}
