package org.sami.crw.operator.map;

import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.LineSegment;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.spn.value.GeoPoint;

/**
 * What a boat drives along, and how much of it is behind the boat: a path with its turns around what is not to be entered, where they are known. The boat
 * tells which points of the path it has visited; which turns between two of them are behind it is judged by where it is. Immutable.
 *
 * @param points in driving order
 * @param behind how many of them are behind the boat
 */
public record WayAhead(List<GeoPoint> points, int behind) {
    /** So near a leg a boat is on it: as far aside as boats go to let others pass, and as positions err. */
    private static final double ON_LEG_M = 12;

    /** So far along the leg behind a turn a boat has passed the turn. */
    private static final double BEHIND_TURN_M = 1;

    /**
     * The way of a boat.
     *
     * @param path the points that the command names
     * @param visited how many of them the boat has visited
     * @param driven the points that the boat was sent; empty where they are not known
     * @param at where the boat is, if that is known
     */
    public static WayAhead of(
            List<GeoPoint> path, int visited, Optional<List<GeoPoint>> driven, Optional<GeoPoint> at) {
        if (driven.isEmpty() || driven.get().size() <= path.size()) {
            return new WayAhead(path, visited);
        }
        List<GeoPoint> points = driven.get();
        int behind = 0;
        for (int i = 0; i < visited; i++) {
            int found = indexOf(path.get(i), points, behind);
            if (found < 0) {
                return new WayAhead(path, visited); // another path's
            }
            behind = found + 1;
        }
        int next = visited < path.size() ? indexOf(path.get(visited), points, behind) : points.size();
        for (int turn = next - 1; turn >= behind && at.isPresent(); turn--) {
            if (isPast(at.get(), points.get(turn), points.get(turn + 1))) {
                return new WayAhead(points, turn + 1);
            }
        }
        return new WayAhead(points, behind);
    }

    private static int indexOf(GeoPoint point, List<GeoPoint> points, int from) {
        for (int i = from; i < points.size(); i++) {
            if (points.get(i).equals(point)) {
                return i;
            }
        }
        return -1;
    }

    /** Whether a boat has passed a turn: it is on the leg behind it. */
    private static boolean isPast(GeoPoint at, GeoPoint turn, GeoPoint next) {
        LocalPlane plane = new LocalPlane(at);
        LineSegment leg = new LineSegment(Areas.coordinate(turn, plane), Areas.coordinate(next, plane));
        Coordinate boat = Areas.coordinate(at, plane);
        return leg.projectionFactor(boat) * leg.getLength() > BEHIND_TURN_M && leg.distance(boat) <= ON_LEG_M;
    }
}
