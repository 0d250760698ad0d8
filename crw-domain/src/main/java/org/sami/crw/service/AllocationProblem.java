package org.sami.crw.service;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.value.GeoPoint;

/**
 * What is to be allocated to whom.
 *
 * @param boats position of each boat; their order decides ties, the earlier boat wins
 * @param locations to visit; the same point twice is two locations
 */
public record AllocationProblem(Map<String, GeoPoint> boats, List<GeoPoint> locations) {
    public AllocationProblem {
        boats = Collections.unmodifiableMap(new LinkedHashMap<>(boats));
        locations = List.copyOf(locations);
        if (boats.isEmpty() && !locations.isEmpty()) {
            throw new IllegalArgumentException(
                    "There is no boat to which " + locations.size() + " locations could be allocated");
        }
    }
}
