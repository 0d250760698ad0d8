package org.sami.session.record;

import java.util.List;
import java.util.Objects;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.spn.value.GeoPoint;

/**
 * What one channel of one of a boat's sensors measured, as a session notes it.
 *
 * @param atMillis when the base received it, in the session's time
 * @param values at least one
 * @param unit of the values; empty for none
 * @param position where the boat took itself to be, to a centimetre
 */
public record SensorValue(
        long atMillis,
        String boat,
        String sensor,
        String channel,
        List<Double> values,
        String unit,
        GeoPoint position) {
    private static final double PER_DEGREE = 1e7;

    public SensorValue {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(sensor, "sensor");
        Objects.requireNonNull(channel, "channel");
        values = List.copyOf(values);
        Objects.requireNonNull(unit, "unit");
        Objects.requireNonNull(position, "position");
    }

    /** A reading of a boat at a moment. */
    public static SensorValue of(long atMillis, String boat, BoatReading reading) {
        return new SensorValue(
                atMillis,
                boat,
                reading.sensor(),
                reading.channel(),
                reading.values(),
                reading.unit(),
                GeoPoint.of(
                        rounded(reading.position().latDeg()),
                        rounded(reading.position().lonDeg())));
    }

    /** To a centimetre: no boat knows better where it was, and hours of readings take much room. */
    private static double rounded(double deg) {
        return Math.rint(deg * PER_DEGREE) / PER_DEGREE;
    }
}
