package org.sami.crw.service.path;

import java.util.Objects;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * A problem of finding a way.
 *
 * @param clearanceM distance that a safe way keeps from forbidden areas where there is room, more than zero
 * @param detour factor on the shortest way that a way may take to keep its distance, 1 or more
 */
public record PathProblem(GeoPoint from, GeoPoint to, Water water, double clearanceM, double detour) {
    /** What a detour is worth unless it is said: half as long again. */
    public static final double DETOUR = 1.5;

    /** A way whose detours may be as long as usual. */
    public PathProblem(GeoPoint from, GeoPoint to, Water water, double clearanceM) {
        this(from, to, water, clearanceM, DETOUR);
    }

    public PathProblem {
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
        Objects.requireNonNull(water, "water");
        if (!(clearanceM > 0) || clearanceM > 1000) {
            throw new IllegalArgumentException("The clearance is more than 0 m and at most 1 km, not " + clearanceM);
        }
        if (!(detour >= 1)) {
            throw new IllegalArgumentException("A detour is 1 or more times the shortest way, not " + detour);
        }
    }
}
