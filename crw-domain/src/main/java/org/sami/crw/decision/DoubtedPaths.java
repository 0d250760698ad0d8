package org.sami.crw.decision;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.GeoPath;

/**
 * Where boats would go about whose ways the operator is asked. Immutable.
 *
 * @param mission that wants it
 * @param byBoat the points that are left of each boat's path, not empty
 */
public record DoubtedPaths(long mission, Map<String, GeoPath> byBoat) {
    public DoubtedPaths {
        Objects.requireNonNull(byBoat, "byBoat");
        byBoat = Collections.unmodifiableMap(new LinkedHashMap<>(byBoat));
    }
}
