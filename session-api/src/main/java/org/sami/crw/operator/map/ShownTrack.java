package org.sami.crw.operator.map;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * Where a boat was, oldest first; thinned, so that it is bounded however long the session lasts.
 *
 * @param points at least one
 */
public record ShownTrack(String boat, List<Point> points) {

    /** Where it was at a moment on the session's clock. */
    public record Point(GeoPoint position, long atMillis) {}

    public ShownTrack {
        Objects.requireNonNull(boat, "boat");
        points = List.copyOf(points);
    }
}
