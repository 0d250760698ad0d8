package org.sami.boat.server;

import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Steers the vehicle along a heading: one loop for the heading, feed-forward and a second loop for the speed. Steering has priority over thrust, and the
 * boat slows down while it points elsewhere, so that it turns on the spot instead of circling a target.
 *
 * <p>The integral of the speed loop compensates current and wear only. It does not integrate while the boat accelerates or while steering uses the thrust.
 * When the boat has to stand, it keeps the part of the integral that slows it down.
 */
final class SteeringControl {
    /** Largest lack of speed that is integrated, in m/s: with more, the boat is still accelerating. */
    private static final double INTEGRATED_LACK_MPS = 0.6;

    private final Vehicle vehicle;
    private final double fullThrustSpeedMps;
    private final PidController heading;
    private final PidController speed;
    private boolean hadThrust = true; // the motors gave all the thrust that was asked for last
    private boolean stands; // has to stand

    SteeringControl(Vehicle vehicle, ServerConfig config) {
        this.vehicle = vehicle;
        fullThrustSpeedMps = config.fullThrustSpeedMps();
        heading = new PidController(config.headingGains());
        speed = new PidController(config.speedGains());
    }

    /** Sets the gains of a loop, which is reset. */
    void setGains(GainAxis axis, Gains gains) {
        loop(axis).setGains(gains);
    }

    Gains gains(GainAxis axis) {
        return loop(axis).gains();
    }

    private PidController loop(GainAxis axis) {
        return axis == GainAxis.HEADING ? heading : speed;
    }

    /** Metres to a target, which is the origin of its frame. */
    double distanceM(LocalFrame target) {
        return target.distanceM(vehicle.latDeg(), vehicle.lonDeg());
    }

    /** Course to a target in radians, clockwise from north; NaN while the vehicle does not know its position. */
    double courseRad(LocalFrame target) {
        double eastM = target.eastM(vehicle.latDeg(), vehicle.lonDeg());
        double northM = target.northM(vehicle.latDeg(), vehicle.lonDeg());
        return StrictMath.atan2(-eastM, -northM);
    }

    /**
     * Steers a heading in radians, clockwise from north, for one tick; rests while the vehicle does not know its position, heading or speed.
     *
     * @param speedMps along that heading; at 0 the motors hold the vehicle as well as they can
     */
    void steerAlong(double headingRad, double speedMps, double seconds) {
        steer(headingRad, speedMps, 0, seconds);
    }

    /**
     * Holds the vehicle's place for one tick by heading into the drift.
     *
     * @param headingRad against the drift, in radians
     * @param driftMps known speed of the drift; the speed loop compensates the rest
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
        double integratedS = hadThrust && Math.abs(lackMps) < INTEGRATED_LACK_MPS ? seconds : 0;
        double throughMps = wantedMps + driftMps * ahead;
        double thrust = throughMps / fullThrustSpeedMps + speed.effort(lackMps, integratedS);
        drive(thrust, heading.effort(error, seconds));
    }

    /** Sets the motors for efforts ahead and to starboard; where they exceed what the motors give, steering has priority. */
    void drive(double thrust, double rudder) {
        double room = 1 - Math.abs(rudder);
        double ahead = Math.max(-room, Math.min(room, thrust));
        hadThrust = ahead == thrust;
        vehicle.setMotors(ahead + rudder, ahead - rudder);
    }

    /** Stops the motors and resets the loops. */
    void rest() {
        vehicle.setMotors(0, 0);
        heading.reset();
        speed.reset();
        hadThrust = true;
        stands = false;
    }
}
