package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.TrackingError;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.CameraShot;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.boat.server.vehicle.Vehicle;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** A hull that does at once what its motors say: 3 m/s at most, one and a half radians a second. */
final class TestHull implements Vehicle {
    private static final double TOP_SPEED_MPS = 3;
    private static final double TURN_RAD_PER_S = 1.5;

    /** How far the boat says that it may be off its ways. */
    Optional<TrackingError> error = Optional.empty();

    /** How far, how fast and how narrowly the boat says that it drives. */
    BoatPerformance performance = BoatPerformance.UNKNOWN;

    /** Whether it knows where it is. */
    boolean isLocated = true;

    private GeoPoint position;
    private double headingRad;
    private double port;
    private double starboard;
    private double batteryPercent = 100;
    private final List<Double> pictures = new ArrayList<>();
    private boolean hasCamera;
    private final List<Sensor> sensors = new ArrayList<>();

    TestHull(GeoPoint position) {
        this.position = position;
    }

    void step(double seconds) {
        headingRad = Math.IEEEremainder(headingRad + seconds * TURN_RAD_PER_S * (port - starboard) / 2, 2 * Math.PI);
        double metres = speedMps() * seconds;
        position = Geodesy.offset(position, metres * Math.sin(headingRad), metres * Math.cos(headingRad));
    }

    GeoPoint position() {
        return position;
    }

    boolean isAtRest() {
        return Math.abs(port) < 1e-9 && Math.abs(starboard) < 1e-9;
    }

    /** Something carries it elsewhere. */
    void drift(double eastM, double northM) {
        position = Geodesy.offset(position, eastM, northM);
    }

    /** An instrument that reads once a second what it is set to. */
    void measures(String instrument, String channel, double value) {
        sensors.add(new Sensor() {
            @Override
            public String name() {
                return instrument;
            }

            @Override
            public String channel() {
                return channel;
            }

            @Override
            public String unit() {
                return "";
            }

            @Override
            public long periodMs() {
                return 1000;
            }

            @Override
            public List<Double> read() {
                return Sensor.single(value);
            }
        });
    }

    void setBatteryPercent(double percent) {
        batteryPercent = percent;
    }

    @Override
    public double latDeg() {
        return isLocated ? position.latDeg() : Double.NaN;
    }

    @Override
    public double lonDeg() {
        return isLocated ? position.lonDeg() : Double.NaN;
    }

    @Override
    public double headingRad() {
        return headingRad;
    }

    @Override
    public double speedMps() {
        return TOP_SPEED_MPS * (port + starboard) / 2;
    }

    @Override
    public double batteryPercent() {
        return batteryPercent;
    }

    /** It has a camera. */
    void photographs() {
        hasCamera = true;
    }

    /** Headings at which pictures were taken, in radians. */
    List<Double> pictures() {
        return pictures;
    }

    @Override
    public Optional<Camera> camera() {
        return hasCamera ? Optional.of(this::takePicture) : Optional.empty();
    }

    private CameraShot takePicture() {
        pictures.add(headingRad);
        return CameraShot.withoutFile();
    }

    @Override
    public List<Sensor> sensors() {
        return sensors;
    }

    @Override
    public void setMotors(double newPort, double newStarboard) {
        port = newPort;
        starboard = newStarboard;
    }
}
