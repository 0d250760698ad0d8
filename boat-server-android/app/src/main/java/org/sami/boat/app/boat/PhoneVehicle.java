package org.sami.boat.app.boat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * A hull with a phone on it, as the boat server's vehicle: it drives nothing while it is stopped on board, its charge is that of the weaker of the two
 * batteries, as the boat is lost without either, and the phone is one of its instruments.
 */
final class PhoneVehicle implements Vehicle {
    private final Vehicle hull;
    private final PhoneHealth phone;
    private final PhoneStop stop;
    private final PhoneCamera camera;

    PhoneVehicle(Vehicle hull, PhoneHealth phone, PhoneStop stop, PhoneCamera camera) {
        this.hull = hull;
        this.phone = phone;
        this.stop = stop;
        this.camera = camera;
    }

    @Override
    public double latDeg() {
        return hull.latDeg();
    }

    @Override
    public double lonDeg() {
        return hull.lonDeg();
    }

    @Override
    public double headingRad() {
        return hull.headingRad();
    }

    @Override
    public double speedMps() {
        return hull.speedMps();
    }

    @Override
    public double batteryPercent() {
        double ofPhone = phone.batteryPercent();
        return Double.isNaN(ofPhone) ? hull.batteryPercent() : Math.min(hull.batteryPercent(), ofPhone);
    }

    @Override
    public List<Sensor> sensors() {
        List<Sensor> all = new ArrayList<>(hull.sensors());
        all.addAll(phone.sensors());
        return all;
    }

    /** There is none while the phone has none, or does not let the app use it. */
    @Override
    public Optional<Camera> camera() {
        return camera.trouble().isEmpty() ? Optional.of(camera) : Optional.empty();
    }

    @Override
    public String cameraTrouble() {
        return camera.trouble();
    }

    @Override
    public Optional<BoardCondition> board() {
        return hull.board();
    }

    @Override
    public void setMotors(double port, double starboard) {
        boolean stopped = stop.isLatched();
        hull.setMotors(stopped ? 0 : port, stopped ? 0 : starboard);
    }
}
