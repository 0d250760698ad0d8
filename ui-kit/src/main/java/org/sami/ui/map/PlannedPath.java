package org.sami.ui.map;

import java.util.List;
import java.util.Objects;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPoint;

/**
 * A path that a vehicle follows, or would follow.
 *
 * @param id stable, unique among paths
 * @param mark its vehicle's, or of an option
 * @param next index of the point that is gone to now: the leg that ends there is the current one, all before is done; 0 where
 *     nothing is done, the number of points where all is
 */
public record PlannedPath(String id, IdentityMark mark, List<GeoPoint> points, int next) {
    public PlannedPath {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(mark, "mark");
        points = List.copyOf(points);
        if (next < 0 || next > points.size()) {
            throw new IllegalArgumentException(
                    "The next point of a path with " + points.size() + " points is not number " + next);
        }
    }
}
