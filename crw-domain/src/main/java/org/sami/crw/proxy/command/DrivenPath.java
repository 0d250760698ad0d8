package org.sami.crw.proxy.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.Waypoint;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * What a boat drives along for a path: its points, and between them those at which it turns to keep clear of what is not to be entered
 * (docs/services.md). Immutable.
 */
public final class DrivenPath {
    private final List<GeoPoint> points;
    private final int[] indexOf; // of each point of the path

    private DrivenPath(List<GeoPoint> points, int[] indexOf) {
        this.points = List.copyOf(points);
        this.indexOf = indexOf;
    }

    /**
     * The way along a path for a boat.
     *
     * @param visited number of points already visited: the legs between them are not driven again
     * @param from position of the boat, if known
     * @param water where the boat may go, if limited
     */
    public static DrivenPath of(List<GeoPoint> path, int visited, Optional<GeoPoint> from, Optional<Water> water) {
        return of(path, visited, from, List.of(), water);
    }

    /**
     * The same for a boat that first drives on along an earlier line.
     *
     * @param before the points of that line, to be driven before the path's first point that is not visited
     */
    public static DrivenPath of(
            List<GeoPoint> path, int visited, Optional<GeoPoint> from, List<GeoPoint> before, Optional<Water> water) {
        List<GeoPoint> points = new ArrayList<>();
        int[] indexOf = new int[path.size()];
        Optional<GeoPoint> at = before.isEmpty() ? from : Optional.of(before.get(before.size() - 1));
        for (int i = 0; i < path.size(); i++) {
            GeoPoint point = path.get(i);
            if (i == visited) {
                points.addAll(before);
            }
            if (i >= visited && at.isPresent() && water.isPresent()) {
                double altM = Math.max(at.get().altM(), point.altM()); // an aircraft descends behind the last turn
                Detour.between(at.get(), point, water.get())
                        .ifPresent(turns ->
                                turns.forEach(turn -> points.add(new GeoPoint(turn.latDeg(), turn.lonDeg(), altM))));
            }
            at = i >= visited ? Optional.of(point) : at;
            indexOf[i] = points.size();
            points.add(point);
        }
        return new DrivenPath(points, indexOf);
    }

    /** The way that a boat holds already, if it is one along the path: the path's points are on it in their order, its last at the end. */
    public static Optional<DrivenPath> held(List<Waypoint> held, List<Waypoint> path) {
        int[] indexOf = new int[path.size()];
        List<GeoPoint> points = new ArrayList<>();
        int next = 0;
        for (Waypoint waypoint : held) {
            if (next < path.size() && waypoint.equals(path.get(next))) {
                indexOf[next++] = points.size();
            }
            points.add(new GeoPoint(waypoint.latDeg(), waypoint.lonDeg(), waypoint.altM()));
        }
        boolean ends = next == path.size() && (next == 0 ? held.isEmpty() : indexOf[next - 1] == held.size() - 1);
        return ends ? Optional.of(new DrivenPath(points, indexOf)) : Optional.empty();
    }

    /** All points in driving order. */
    public List<GeoPoint> points() {
        return points;
    }

    /** Index of the first point to drive to when so many points of the path are behind the boat. */
    public int indexAfter(int visited) {
        return visited == 0 ? 0 : indexOf[visited - 1] + 1;
    }

    /** How many points of the path are behind the boat when so many of all points are. */
    public int visited(int driven) {
        int visited = 0;
        while (visited < indexOf.length && indexOf[visited] < driven) {
            visited++;
        }
        return visited;
    }
}
