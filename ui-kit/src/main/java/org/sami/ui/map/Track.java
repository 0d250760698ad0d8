package org.sami.ui.map;

import java.util.List;
import java.util.Objects;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPoint;

/**
 * Where a vehicle has been, from the oldest point on.
 *
 * @param id of the vehicle
 * @param mark its identity's
 */
public record Track(String id, IdentityMark mark, List<GeoPoint> points) {
    public Track {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(mark, "mark");
        points = List.copyOf(points);
    }
}
