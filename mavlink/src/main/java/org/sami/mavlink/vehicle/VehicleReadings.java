package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.ardupilotmega.Rangefinder;
import io.dronefleet.mavlink.ardupilotmega.WaterDepth;
import io.dronefleet.mavlink.ardupilotmega.Wind;
import io.dronefleet.mavlink.common.DistanceSensor;
import io.dronefleet.mavlink.common.NamedValueFloat;
import io.dronefleet.mavlink.common.NamedValueInt;
import java.util.List;

/** Reads values of sensors out of messages. */
final class VehicleReadings {
    private static final double FROM_CENTI = 1e-2;
    private static final String METRES = "m";

    private VehicleReadings() {}

    /** The values that a message has; none where it is no message of a sensor. Values that are no number are left out. */
    static List<VehicleReading> of(Object message) {
        return all(message).stream()
                .filter(reading -> Double.isFinite(reading.value()))
                .toList();
    }

    private static List<VehicleReading> all(Object message) {
        if (message instanceof NamedValueFloat named) {
            return List.of(new VehicleReading(named.name(), named.value(), ""));
        } else if (message instanceof NamedValueInt named) {
            return List.of(new VehicleReading(named.name(), named.value(), ""));
        } else if (message instanceof WaterDepth water && water.healthy() != 0) {
            VehicleReading depth = new VehicleReading("depth", water.distance(), METRES);
            return water.temperature() == 0 // a sounder without a thermometer says 0, as ArduPilot sends it
                    ? List.of(depth)
                    : List.of(depth, new VehicleReading("temperature", water.temperature(), "°C"));
        } else if (message instanceof DistanceSensor distance) {
            return List.of(new VehicleReading("distance", distance.currentDistance() * FROM_CENTI, METRES));
        } else if (message instanceof Rangefinder range) {
            return List.of(new VehicleReading("range", range.distance(), METRES));
        } else if (message instanceof Wind wind) {
            return List.of(new VehicleReading("wind", wind.speed(), "m/s"));
        }
        return List.of();
    }
}
