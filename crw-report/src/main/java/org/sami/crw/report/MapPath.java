package org.sami.crw.report;

import java.util.List;
import java.util.Objects;

/**
 * A path that a mission gave a boat.
 *
 * @param atMillis when, in ms since the start
 * @param points in the order in which they are to be visited
 */
public record MapPath(String boat, long mission, long atMillis, List<MapPoint> points) {
    public MapPath {
        Objects.requireNonNull(boat, "boat");
        points = List.copyOf(points);
    }
}
