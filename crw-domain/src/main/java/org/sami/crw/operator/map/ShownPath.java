package org.sami.crw.operator.map;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * Where a boat is to go.
 *
 * @param mission that wants it
 * @param command id of the command
 * @param points in driving order, with the turns around what is not to be entered where they are known; one point where it is to stay there
 * @param visited how many points are behind the boat
 * @param current whether the boat does it now, rather than later
 */
public record ShownPath(
        String boat, long mission, String command, List<GeoPoint> points, int visited, boolean current) {
    public ShownPath {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(command, "command");
        points = List.copyOf(points);
    }

    /** The points that are still ahead. */
    public List<GeoPoint> ahead() {
        return points.subList(Math.min(visited, points.size()), points.size());
    }
}
