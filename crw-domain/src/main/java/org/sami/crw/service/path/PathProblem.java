package org.sami.crw.service.path;

import java.util.Objects;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * A way to be found.
 *
 * @param clearanceM the distance that a safe way keeps from what is forbidden where there is room, more than zero
 */
public record PathProblem(GeoPoint from, GeoPoint to, Water water, double clearanceM) {
    public PathProblem {
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
        Objects.requireNonNull(water, "water");
        if (!(clearanceM > 0) || clearanceM > 1000) {
            throw new IllegalArgumentException("The clearance is more than 0 m and at most 1 km, not " + clearanceM);
        }
    }
}
