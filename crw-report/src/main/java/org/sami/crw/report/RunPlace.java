package org.sami.crw.report;

import java.util.Objects;
import java.util.Optional;

/**
 * Where on earth a run took place.
 *
 * @param centre of the area, from which metres east and north are counted
 * @param quay the middle of the line in which the boats lay at the start; empty for boats that are other processes
 */
public record RunPlace(MapPoint centre, Optional<MapPoint> quay) {
    public RunPlace {
        Objects.requireNonNull(centre, "centre");
        Objects.requireNonNull(quay, "quay");
    }
}
