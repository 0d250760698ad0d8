package org.sami.boat.server;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.SensorReport;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.boat.server.vehicle.Vehicle;

/** Reads the sensors of a vehicle, each at its own rate, with place and time. */
final class SensorSampler {
    private final Vehicle vehicle;
    private final List<Slot> slots = new ArrayList<>();

    SensorSampler(Vehicle vehicle) {
        this.vehicle = vehicle;
        vehicle.sensors().forEach(sensor -> slots.add(new Slot(sensor)));
    }

    /** The channels that the vehicle measures, each as {@code sensor/channel}; no more than are said over the link. */
    List<String> channels() {
        List<String> channels = new ArrayList<>();
        for (Slot slot : slots) {
            if (channels.size() < BoatCapabilities.MOST_CHANNELS) {
                channels.add(slot.sensor.name() + "/" + slot.sensor.channel());
            }
        }
        return channels;
    }

    /** Whether a sensor is due. None is while the boat does not know where it is: a reading has a place. */
    boolean areDue(long nowMs) {
        if (Double.isNaN(vehicle.latDeg() + vehicle.lonDeg())) {
            return false;
        }
        for (Slot slot : slots) {
            if (nowMs >= slot.dueMs) {
                return true;
            }
        }
        return false;
    }

    /** Reads the sensors that are due. A sensor that fails is read again when it is next due, and does not stop the others. */
    void tick(long nowMs, Consumer<SensorReport> reports) {
        RuntimeException failure = null;
        for (Slot slot : slots) {
            if (nowMs >= slot.dueMs) {
                slot.plan(nowMs);
                try {
                    read(slot.sensor, nowMs, reports);
                } catch (RuntimeException e) {
                    failure = e;
                }
            }
        }
        if (failure != null) {
            throw failure;
        }
    }

    private void read(Sensor sensor, long nowMs, Consumer<SensorReport> reports) {
        List<Double> values = sensor.read();
        if (!values.isEmpty() && values.stream().allMatch(SensorSampler::isFinite)) {
            reports.accept(new SensorReport(
                    sensor.name(), sensor.channel(), values, sensor.unit(), vehicle.latDeg(), vehicle.lonDeg(), nowMs));
        }
    }

    private static boolean isFinite(double value) {
        return !Double.isNaN(value) && !Double.isInfinite(value);
    }

    /** A sensor and its next reading. */
    private static final class Slot {
        private final Sensor sensor;
        private long dueMs = Long.MIN_VALUE;

        Slot(Sensor sensor) {
            this.sensor = sensor;
        }

        void plan(long nowMs) {
            boolean onTime = dueMs > nowMs - sensor.periodMs();
            dueMs = (onTime ? dueMs : nowMs) + sensor.periodMs();
        }
    }
}
