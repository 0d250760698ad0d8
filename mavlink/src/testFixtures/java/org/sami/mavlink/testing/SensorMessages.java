package org.sami.mavlink.testing;

import io.dronefleet.mavlink.ardupilotmega.Rangefinder;
import io.dronefleet.mavlink.common.NamedValueFloat;

/** Messages with values of a vehicle's sensors, for {@link SmallBoat#sends}. */
public final class SensorMessages {
    private SensorMessages() {}

    /** A value under a name of at most 10 characters. */
    public static Object named(String name, double value) {
        return NamedValueFloat.builder().name(name).value((float) value).build();
    }

    /** What a depth sounder or rangefinder measures, in metres. */
    public static Object range(double metres) {
        return Rangefinder.builder().distance((float) metres).build();
    }
}
