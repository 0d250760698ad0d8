package org.sami.boat.mavlink;

import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/** A hull without inertia on still water: its speed is the mean of its motors, its turn their difference. For the boat's thread. */
final class DrivenHull implements Vehicle {
    private static final double FULL_MPS = 3.2;
    private static final double FULL_TURN_RADPS = 1.5;

    private final LocalFrame start;
    private double eastM;
    private double northM;
    private double headingRad;
    private double speedMps;
    private boolean hasFix = true;
    private double port;
    private double starboard;

    DrivenHull(double latDeg, double lonDeg) {
        start = new LocalFrame(latDeg, lonDeg);
    }

    void move(double seconds) {
        speedMps = (port + starboard) / 2 * FULL_MPS;
        headingRad = Math.IEEEremainder(headingRad + (port - starboard) / 2 * FULL_TURN_RADPS * seconds, 2 * Math.PI);
        eastM += speedMps * Math.sin(headingRad) * seconds;
        northM += speedMps * Math.cos(headingRad) * seconds;
    }

    /** Its position is unknown from now on. */
    void loseFix() {
        hasFix = false;
    }

    @Override
    public double latDeg() {
        return hasFix ? start.latDeg(eastM, northM) : Double.NaN;
    }

    @Override
    public double lonDeg() {
        return start.lonDeg(eastM, northM);
    }

    @Override
    public double headingRad() {
        return headingRad;
    }

    @Override
    public double speedMps() {
        return speedMps;
    }

    @Override
    public double batteryPercent() {
        return 90;
    }

    @Override
    public void setMotors(double newPort, double newStarboard) {
        port = newPort;
        starboard = newStarboard;
    }
}
