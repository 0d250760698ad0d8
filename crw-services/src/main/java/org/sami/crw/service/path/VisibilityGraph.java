package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Point;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.distance.DistanceOp;
import org.sami.crw.service.Interruption;
import org.sami.crw.service.water.Water;

/**
 * Shortest ways around polygons: a shortest way is straight but for turns at their convex corners (T. Lozano-Pérez, M. A. Wesley, An
 * algorithm for planning collision-free paths among polyhedral obstacles, 1979). The corners stand a little off, so that a way never
 * touches what it goes around.
 *
 * <p>The graph is not built: A* takes a leg for free until it would use it, and tests it only then. Legs that are no tangents
 * at both ends are not looked at, as they are on no shortest way. For n corners O(n² log n) at worst.
 */
public final class VisibilityGraph {
    /** Corners stand off what is blocked by this, in metres. */
    static final double STAND_OFF_M = 0.1;

    /** Slivers narrower than this, in metres, are roundings of corners and no gaps. */
    private static final double LEAST_GAP_M = 0.05;

    /** At so little clearance, in metres, a corner is passed with one turn, not in a circle. */
    private static final double MOST_CORNER_M = 1;

    /** Places, and lines, so near to one another, in metres, are the same but for rounding. */
    private static final double SAME_PLACE_M = 1e-6;

    private static final int QUADRANT_SEGMENTS = 4;
    /** A circle's polygon of that many segments lies inside the circle, by this factor where it is nearest. */
    private static final double INSIDE = Math.cos(Math.PI / 4 / QUADRANT_SEGMENTS);

    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final Geometry blocked;
    private final Geometry around;
    private final PreparedGeometry prepared;
    private final List<Coordinate> corners;
    /** The corners before and after each on its ring. */
    private final List<Coordinate[]> neighbours;

    private long tested;

    /**
     * A graph.
     *
     * @param forbidden polygons on a plane
     * @param clearanceM least distance that ways keep from them; zero = they pass close by
     */
    public VisibilityGraph(Geometry forbidden, double clearanceM) {
        this(around(forbidden, clearanceM), corners(forbidden, clearanceM));
    }

    /**
     * The graph of the ways around what is forbidden in a water; its parts are computed once for each water and clearance.
     *
     * @param clearanceM least distance that ways keep
     */
    static VisibilityGraph of(Water water, double clearanceM) {
        return new VisibilityGraph(water.derived(
                new Clearance(clearanceM, clearanceM),
                VisibilityGraph.class,
                () -> new VisibilityGraph(water.forbidden(), clearanceM)));
    }

    /** The same with gaps, as in {@link #withGaps(Geometry, double, double)}. */
    static VisibilityGraph withGaps(Water water, double clearanceM, double gapM) {
        return new VisibilityGraph(water.derived(
                new Clearance(clearanceM, gapM),
                VisibilityGraph.class,
                () -> withGaps(water.forbidden(), clearanceM, gapM)));
    }

    /** By what a water's graphs differ. */
    private record Clearance(double clearanceM, double gapM) {}

    /** The same graph, which counts its own tests: threads may share the parts. */
    private VisibilityGraph(VisibilityGraph other) {
        blocked = other.blocked;
        around = other.around;
        prepared = other.prepared;
        corners = other.corners;
        neighbours = other.neighbours;
    }

    /** What ways turn at: corners of what is blocked where it is near, circles about them where ways keep far off. */
    private static Geometry corners(Geometry forbidden, double clearanceM) {
        return clearanceM <= MOST_CORNER_M
                ? BufferOp.bufferOp(forbidden, clearanceM / INSIDE + STAND_OFF_M, mitred())
                : forbidden.buffer(clearanceM / INSIDE / INSIDE + STAND_OFF_M, QUADRANT_SEGMENTS);
    }

    private VisibilityGraph(Geometry blocked, Geometry around) {
        this.blocked = blocked;
        this.around = around;
        corners = new ArrayList<>();
        neighbours = new ArrayList<>();
        prepared = PreparedGeometryFactory.prepare(blocked);
        for (int i = 0; i < around.getNumGeometries(); i++) {
            Polygon polygon = (Polygon) around.getGeometryN(i);
            addRing(polygon.getExteriorRing(), true);
            for (int hole = 0; hole < polygon.getNumInteriorRing(); hole++) {
                addRing(polygon.getInteriorRingN(hole), false);
            }
        }
    }

    /**
     * A graph whose ways keep a clearance where there is room, and less in gaps that are too narrow. The gaps are the difference between the polygons
     * grown by the clearance, and shrunk again, and the original polygons.
     *
     * @param gapM clearance in the gaps, less than the general clearance
     */
    static VisibilityGraph withGaps(Geometry forbidden, double clearanceM, double gapM) {
        Geometry wide = around(forbidden, clearanceM);
        Geometry tight = around(forbidden, gapM);
        double stepM = clearanceM - gapM;
        Geometry gaps = wide.buffer(-stepM, QUADRANT_SEGMENTS)
                .difference(around(forbidden, gapM + LEAST_GAP_M))
                .buffer(-LEAST_GAP_M);
        if (gaps.isEmpty()) {
            return new VisibilityGraph(forbidden, clearanceM);
        }
        Geometry open = gaps.buffer(stepM + 2 * LEAST_GAP_M + STAND_OFF_M, QUADRANT_SEGMENTS);
        Geometry blocked = wide.difference(open).union(tight);
        return new VisibilityGraph(blocked, blocked.buffer(STAND_OFF_M, QUADRANT_SEGMENTS));
    }

    private static Geometry around(Geometry forbidden, double clearanceM) {
        return clearanceM > 0 ? forbidden.buffer(clearanceM / INSIDE, QUADRANT_SEGMENTS) : forbidden;
    }

    private static BufferParameters mitred() {
        BufferParameters parameters = new BufferParameters();
        parameters.setJoinStyle(BufferParameters.JOIN_MITRE);
        return parameters;
    }

    private void addRing(LinearRing ring, boolean exterior) {
        Coordinate[] all = ring.getCoordinates();
        boolean blockedOnTheLeft = Orientation.isCCW(all) == exterior;
        int size = all.length - 1;
        for (int i = 0; i < size; i++) {
            Interruption.check();
            Coordinate before = all[(i + size - 1) % size];
            Coordinate after = all[(i + 1) % size];
            int turn = Orientation.index(before, all[i], after);
            if (turn == (blockedOnTheLeft ? Orientation.LEFT : Orientation.RIGHT)) {
                corners.add(all[i]);
                neighbours.add(new Coordinate[] {before, after});
            }
        }
    }

    /** What ways may not enter. */
    boolean isBlocked(Coordinate place) {
        return !blocked.isEmpty() && prepared.intersects(FACTORY.createPoint(place));
    }

    /** Whether a place is not blocked, but so near that it lies behind the corners at which ways turn: no way is found from there. */
    boolean isBehindCorners(Coordinate place) {
        Point point = FACTORY.createPoint(place);
        return !isBlocked(place)
                && around.intersects(point)
                && around.getBoundary().distance(point) > SAME_PLACE_M;
    }

    /** The nearest place that is not blocked. */
    Coordinate nearestFree(Coordinate place) {
        return DistanceOp.nearestPoints(around.getBoundary(), FACTORY.createPoint(place))[0];
    }

    long tested() {
        return tested;
    }

    /** The shortest way with both its ends, neither of them blocked; empty where there is none. */
    public Optional<List<Coordinate>> shortest(Coordinate from, Coordinate to) {
        return new Search(from, to).run();
    }

    /** Where ways turn. */
    List<Coordinate> corners() {
        return corners;
    }

    /** Whether a leg between a corner and some place only touches the corner's ring there; always where it is no corner's number. */
    boolean isTangent(int corner, Coordinate other) {
        if (corner >= neighbours.size()) {
            return true;
        }
        Coordinate at = corners.get(corner);
        Coordinate[] beside = neighbours.get(corner);
        return side(at, other, beside[0]) * side(at, other, beside[1]) >= 0;
    }

    /** On which side of a line a place lies; on neither where it is nearer to it than rounding can tell. */
    private static double side(Coordinate from, Coordinate to, Coordinate place) {
        double dx = to.x - from.x;
        double dy = to.y - from.y;
        double offM = (dx * (place.y - from.y) - dy * (place.x - from.x)) / Math.max(1, Math.hypot(dx, dy));
        return Math.abs(offM) < SAME_PLACE_M ? 0 : Math.signum(offM);
    }

    /** Whether nothing that is blocked lies between two places. */
    boolean sees(Coordinate a, Coordinate b) {
        tested++;
        return a.equals2D(b) || !prepared.intersects(FACTORY.createLineString(new Coordinate[] {a, b}));
    }

    /** A leg that would lead to a corner, not tested yet. */
    private record Leg(int from, int to, double lengthToM, double estimateM) {}

    /** One search: the corners are numbered as they are, then the start, then the goal. */
    private final class Search {
        private final Coordinate goal;
        private final Coordinate[] places;
        private final int[] cameFrom;
        private final boolean[] reached;
        private final PriorityQueue<Leg> open =
                new PriorityQueue<>(Comparator.comparingDouble(Leg::estimateM).thenComparingInt(Leg::to));

        Search(Coordinate from, Coordinate to) {
            goal = to;
            places = corners.toArray(new Coordinate[corners.size() + 2]);
            places[corners.size()] = from;
            places[corners.size() + 1] = to;
            cameFrom = new int[places.length];
            Arrays.fill(cameFrom, -1);
            reached = new boolean[places.length];
        }

        Optional<List<Coordinate>> run() {
            int start = places.length - 2;
            reached[start] = true;
            expand(start, 0);
            while (!open.isEmpty()) {
                Interruption.check();
                Leg leg = open.poll();
                if (reached[leg.to()] || !sees(places[leg.from()], places[leg.to()])) {
                    continue;
                }
                reached[leg.to()] = true;
                cameFrom[leg.to()] = leg.from();
                if (leg.to() == places.length - 1) {
                    return Optional.of(way());
                }
                expand(leg.to(), leg.lengthToM());
            }
            return Optional.empty();
        }

        private void expand(int from, double lengthM) {
            for (int to = 0; to < places.length; to++) {
                if (!reached[to] && isTangent(from, places[to]) && isTangent(to, places[from])) {
                    double toM = lengthM + places[from].distance(places[to]);
                    open.add(new Leg(from, to, toM, toM + places[to].distance(goal)));
                }
            }
        }

        private List<Coordinate> way() {
            List<Coordinate> way = new ArrayList<>();
            for (int at = places.length - 1; at >= 0; at = cameFrom[at]) {
                way.add(places[at]);
            }
            Collections.reverse(way);
            return way;
        }
    }
}
