package org.sami.crw.operator.map;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * Where a boat whose link was lost is expected to come home by itself: it is not seen doing so.
 *
 * @param points from where it was seen last to its home, with the turns between
 */
public record ShownWayHome(String boat, List<GeoPoint> points) {
    public ShownWayHome {
        Objects.requireNonNull(boat, "boat");
        points = List.copyOf(points);
    }
}
