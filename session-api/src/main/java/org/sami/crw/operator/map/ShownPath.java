package org.sami.crw.operator.map;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * A path of a boat.
 *
 * @param mission the mission that sends the boat
 * @param command id of the command
 * @param points in driving order, with known turns around no-go areas; one point for a boat that stays there
 * @param visited number of visited points
 * @param current whether the boat follows it now, and not later
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
