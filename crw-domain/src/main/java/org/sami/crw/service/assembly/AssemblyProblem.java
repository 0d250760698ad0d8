package org.sami.crw.service.assembly;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * Who is to assemble where.
 *
 * @param boats the position of each boat, empty where it is not known
 * @param centre the point about which they assemble
 * @param spacingM least distance between two boats, more than zero
 * @param taken points at which other boats stay
 * @param water where they may be; half the spacing is kept from what is forbidden, and no less than the boats' cross-track error
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
