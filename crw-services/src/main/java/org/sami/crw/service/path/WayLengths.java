package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * The lengths of the ways between points, around forbidden areas, computed all at once. They are those that boats drive: a way keeps its margin
 * unless that makes it longer by more than {@link PathProblem#DETOUR}; where an end lies in a forbidden area, the way leaves or enters it by the
 * shortest way. Immutable.
 */
public final class WayLengths {
    /** For more points lengths are straight. */
    public static final int MOST_POINTS = 250;

    /** For more corners of what is forbidden lengths are straight. */
    static final int MOST_CORNERS = 1500;

    private final Map<GeoPoint, Integer> indices;
    private final double[][] lengthM;
    private final Optional<String> shortfall;

    /**
     * Where ways from and to a point begin.
     *
     * @param place the point itself, or the nearest place at which ways keep clear
     * @param wayM how far that is from the point; infinite where no way leads out
     */
    private record Access(Coordinate place, double wayM) {
        static Access of(GeoPoint point, Water water, VisibilityGraph graph) {
            Coordinate at = Areas.coordinate(point, water.plane());
            boolean isBlocked = graph.isBlocked(at);
            if (!isBlocked && !graph.isBehindCorners(at)) {
                return new Access(at, 0);
            }
            Coordinate free = graph.nearestFree(at);
            boolean isCut =
                    water.clearanceM(point) > 0 && !water.allows(List.of(point, Areas.point(free, water.plane())));
            if (isCut) {
                return new Access(at, isBlocked ? Double.POSITIVE_INFINITY : 0);
            }
            return new Access(free, free.distance(at));
        }
    }

    private WayLengths(Map<GeoPoint, Integer> indices, double[][] lengthM, Optional<String> shortfall) {
        this.indices = indices;
        this.lengthM = lengthM;
        this.shortfall = shortfall;
    }

    /** The lengths between points; straight where nothing is forbidden, or where there are too many points or corners. */
    public static WayLengths between(Collection<GeoPoint> points, Water water) {
        List<GeoPoint> all = new ArrayList<>(new LinkedHashSet<>(points));
        if (water.isOpen()) {
            return straight(Optional.empty());
        }
        if (all.size() > MOST_POINTS) {
            return straight(Optional.of("distances are straight, through no-go areas: " + all.size()
                    + " boats and locations are more than the " + MOST_POINTS + " for which ways around are measured"));
        }
        double leastM = water.error().steeringM();
        double marginM = Math.max(water.margin().pathM(), leastM);
        VisibilityGraph tight = VisibilityGraph.of(water, leastM);
        VisibilityGraph wide = marginM > leastM ? VisibilityGraph.of(water, marginM) : tight;
        int corners = Math.max(tight.corners().size(), wide.corners().size());
        if (corners > MOST_CORNERS) {
            return straight(Optional.of("distances are straight, through no-go areas: these have " + corners
                    + " corners, and ways around are measured for " + MOST_CORNERS));
        }
        double[][] shortest = lengths(all, water, tight);
        double[][] kept = wide == tight ? shortest : lengths(all, water, wide);
        Map<GeoPoint, Integer> indices = new LinkedHashMap<>();
        for (int i = 0; i < all.size(); i++) {
            indices.put(all.get(i), i);
            for (int j = 0; j < all.size(); j++) {
                if (kept[i][j] <= PathProblem.DETOUR * shortest[i][j]) {
                    shortest[i][j] = kept[i][j];
                }
            }
        }
        return new WayLengths(indices, shortest, Optional.empty());
    }

    private static WayLengths straight(Optional<String> shortfall) {
        return new WayLengths(Map.of(), new double[0][], shortfall);
    }

    private static double[][] lengths(List<GeoPoint> points, Water water, VisibilityGraph graph) {
        List<Access> accesses =
                points.stream().map(point -> Access.of(point, water, graph)).toList();
        List<Coordinate> places = accesses.stream().map(Access::place).toList();
        double[][] lengthM = new ShortestWays(graph, places).lengthsM();
        for (int i = 0; i < lengthM.length; i++) {
            for (int j = 0; j < lengthM.length; j++) {
                lengthM[i][j] = i == j
                        ? 0
                        : lengthM[i][j]
                                + accesses.get(i).wayM()
                                + accesses.get(j).wayM();
            }
        }
        return lengthM;
    }

    /** Whether lengths are straight. */
    public boolean isStraight() {
        return indices.isEmpty();
    }

    /** Why lengths are straight although something is to be driven around, in words. */
    public Optional<String> shortfall() {
        return shortfall;
    }

    /** The length of the way between two of the points, in metres; infinite where there is none. */
    public double lengthM(GeoPoint from, GeoPoint to) {
        return isStraight() ? Geodesy.distanceM(from, to) : lengthM[index(from)][index(to)];
    }

    private int index(GeoPoint point) {
        return Objects.requireNonNull(indices.get(point), "a point between which ways were measured");
    }

    /** The length of the way by some of the points, one after another, in metres. */
    public double lengthM(GeoPoint from, List<GeoPoint> by) {
        double metres = 0;
        GeoPoint at = from;
        for (GeoPoint next : by) {
            metres += lengthM(at, next);
            at = next;
        }
        return metres;
    }
}
