package org.sami.crw.decision;

import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * What the simulated operator answers with where nothing else is said.
 *
 * @param quay where boats are launched and recharged
 * @param centre centre of the square in which its locations lie
 * @param areaM side of the square in metres
 * @param locations how many locations it marks where a list of them is asked for
 * @param seed of all that it makes up
 */
public record OperatorDefaults(GeoPoint quay, GeoPoint centre, double areaM, int locations, long seed) {
    public OperatorDefaults {
        Objects.requireNonNull(quay, "quay");
        Objects.requireNonNull(centre, "centre");
        if (!(areaM > 0) || areaM > 100_000) {
            throw new IllegalArgumentException("The area's side is more than 0 m and at most 100 km, not " + areaM);
        }
        if (locations < 0 || locations > 100_000) {
            throw new IllegalArgumentException("The number of locations is from 0 to 100000, not " + locations);
        }
    }

    /** The quay lies in the middle of the square. */
    public OperatorDefaults(GeoPoint centre, double areaM, int locations, long seed) {
        this(centre, centre, areaM, locations, seed);
    }
}
