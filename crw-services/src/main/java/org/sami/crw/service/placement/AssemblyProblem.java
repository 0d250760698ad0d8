package org.sami.crw.service.placement;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * A problem of assembling boats around a point.
 *
 * @param boats the position of each boat, empty where unknown
 * @param centre the point around which they assemble
 * @param spacingM least distance between two boats, more than zero
 * @param taken positions of other boats
 * @param water where the boats may be; they keep half the spacing from forbidden areas, and at least their cross-track error
 */
public record AssemblyProblem(
        Map<String, Optional<GeoPoint>> boats, GeoPoint centre, double spacingM, List<GeoPoint> taken, Water water) {
    /** An assembly in open water. */
    public AssemblyProblem(
            Map<String, Optional<GeoPoint>> boats, GeoPoint centre, double spacingM, List<GeoPoint> taken) {
        this(boats, centre, spacingM, taken, Water.open(centre));
    }

    public AssemblyProblem {
        boats = Collections.unmodifiableMap(new LinkedHashMap<>(boats));
        Objects.requireNonNull(centre, "centre");
        if (!(spacingM > 0) || spacingM > 10_000) {
            throw new IllegalArgumentException("The spacing is more than 0 m and at most 10 km, not " + spacingM);
        }
        taken = List.copyOf(taken);
        Objects.requireNonNull(water, "water");
    }
}
