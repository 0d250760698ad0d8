package org.sami.crw.report;

import java.util.List;
import java.util.Objects;

/**
 * What one channel of one of a boat's sensors measured.
 *
 * @param atMillis when the base received it, from the start of the run
 * @param values at least one
 * @param unit of the values; empty for none
 * @param latDeg where the boat took itself to be
 * @param lonDeg where the boat took itself to be
 */
public record ReadingResult(
        long atMillis,
        String boat,
        String sensor,
        String channel,
        List<Double> values,
        String unit,
        double latDeg,
        double lonDeg) {
    public ReadingResult {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(sensor, "sensor");
        Objects.requireNonNull(channel, "channel");
        values = List.copyOf(values);
        Objects.requireNonNull(unit, "unit");
    }
}
