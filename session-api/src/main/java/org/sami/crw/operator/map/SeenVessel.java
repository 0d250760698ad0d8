package org.sami.crw.operator.map;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.boat.link.LookoutReadings;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.spn.value.GeoPoint;

/**
 * A vessel that is not of the base, as one of its boats sees it.
 *
 * @param number distinguishes it from others on this water
 * @param courseDeg clockwise from north, 0 to 360
 * @param from where the boat is that sees it
 */
public record SeenVessel(
        int number, GeoPoint position, double courseDeg, double speedMps, double lengthM, double beamM, GeoPoint from) {
    private static final double AT_REST_MPS = 0.05;

    /** That of a reading; empty for a reading of something else. */
    public static Optional<SeenVessel> of(BoatReading reading) {
        List<Double> values = reading.values();
        if (!LookoutReadings.isVessel(reading.sensor(), values)) {
            return Optional.empty();
        }
        return Optional.of(new SeenVessel(
                values.get(0).intValue(),
                GeoPoint.of(values.get(1), values.get(2)),
                (values.get(3) % 360 + 360) % 360,
                values.get(4),
                values.get(5),
                values.get(6),
                reading.position()));
    }

    /** What it is and how it moves, for people. */
    public String words() {
        String size = String.format(Locale.ROOT, "vessel %d, %.0f m long", number, lengthM);
        return speedMps < AT_REST_MPS
                ? size + ", at rest"
                : String.format(Locale.ROOT, "%s, %.1f m/s to %03.0f°", size, speedMps, courseDeg);
    }
}
