package org.sami.crw.sim.hull;

import java.util.List;
import java.util.function.DoubleSupplier;
import org.sami.boat.server.vehicle.Sensor;

/** The wind as a simulated copter estimates it from its tilt, in m/s; every five seconds. */
final class WindSensor implements Sensor {
    private final DoubleSupplier windMps;

    WindSensor(DoubleSupplier windMps) {
        this.windMps = windMps;
    }

    @Override
    public String name() {
        return "autopilot";
    }

    @Override
    public String channel() {
        return "wind";
    }

    @Override
    public String unit() {
        return "m/s";
    }

    @Override
    public long periodMs() {
        return 5000;
    }

    @Override
    public List<Double> read() {
        return Sensor.single(windMps.getAsDouble());
    }
}
