package org.sami.crw.decision;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * The simulated operator's default answers.
 *
 * @param quay where boats are launched and recharged
 * @param centre centre of the square for its locations
 * @param areaM side of the square in metres
 * @param locations number of locations that it marks where a list of them is asked for
 * @param seed of all invented values
 * @param boats the boats that get a share where a value for each boat is asked for, and the last of which is named where one boat is asked for
 */
public record DefaultAnswers(
        GeoPoint quay, GeoPoint centre, double areaM, int locations, long seed, List<String> boats) {
    public DefaultAnswers {
        boats = List.copyOf(boats);
        Objects.requireNonNull(quay, "quay");
        Objects.requireNonNull(centre, "centre");
        if (!(areaM > 0) || areaM > 100_000) {
            throw new IllegalArgumentException("The area's side is more than 0 m and at most 100 km, not " + areaM);
        }
        if (locations < 0 || locations > 100_000) {
            throw new IllegalArgumentException("The number of locations is from 0 to 100000, not " + locations);
        }
    }

    /** The names of the boats are not known. */
    public DefaultAnswers(GeoPoint quay, GeoPoint centre, double areaM, int locations, long seed) {
        this(quay, centre, areaM, locations, seed, List.of());
    }

    /** The quay lies in the middle of the square. */
    public DefaultAnswers(GeoPoint centre, double areaM, int locations, long seed) {
        this(centre, centre, areaM, locations, seed);
    }
}
