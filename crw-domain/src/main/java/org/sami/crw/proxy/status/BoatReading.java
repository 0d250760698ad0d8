package org.sami.crw.proxy.status;

import java.util.List;
import java.util.Objects;
import org.sami.boat.link.SensorReport;
import org.sami.spn.value.GeoPoint;

/**
 * What one channel of one of a boat's sensors measured.
 *
 * @param values at least one, all finite
 * @param unit of the values; empty for none
 * @param position where the boat took itself to be
 * @param boatTimeMs when, by the boat's own clock
 */
public record BoatReading(
        String sensor, String channel, List<Double> values, String unit, GeoPoint position, long boatTimeMs) {
    public BoatReading {
        Objects.requireNonNull(sensor, "sensor");
        Objects.requireNonNull(channel, "channel");
        values = List.copyOf(values);
        Objects.requireNonNull(unit, "unit");
        Objects.requireNonNull(position, "position");
    }

    /** That of a report. */
    public static BoatReading of(SensorReport report) {
        return new BoatReading(
                report.sensor(),
                report.channel(),
                report.values(),
                report.unit(),
                GeoPoint.of(report.latDeg(), report.lonDeg()),
                report.boatTimeMs());
    }
}
