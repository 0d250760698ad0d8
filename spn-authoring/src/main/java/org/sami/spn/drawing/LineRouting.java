package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;

/**
 * Leads lines around the vertices that lie in their way: a line that crosses one seems to end there. A line that meets none stays straight;
 * another takes the shortest way along the corners of what it meets (a visibility graph, searched as Dijkstra's algorithm does).
 */
final class LineRouting {
    /** How near a line may pass a vertex that it has nothing to do with. */
    private static final double CLEARANCE = 4;

    private static final double LANE_OFFSET = 12;
    private static final double BEND = 24; // what one bend costs, as length
    private static final double NEXT_LANE = 6;
    private static final int LANES = 5;
    private static final int ROUNDS = 8;
    private static final int MOST_OBSTACLES = 40;

    private final CellGrid<Vertex> grid = new CellGrid<>();
    private final CellGrid<LayoutPoint> bends = new CellGrid<>();

    LineRouting(Collection<Vertex> vertices) {
        vertices.forEach(vertex -> grid.add(vertex.box().grown(CLEARANCE), vertex));
    }

    /**
     * The line of an edge.
     *
     * @param twin whether another edge leads back
     */
    List<LayoutPoint> line(Vertex from, Vertex to, boolean twin) {
        List<LayoutPoint> straight = NetShapes.line(from, to, twin);
        Set<Vertex> met = new LinkedHashSet<>(met(from, to, straight));
        if (met.isEmpty()) {
            return straight;
        }
        for (int round = 0; round < ROUNDS && met.size() <= MOST_OBSTACLES; round++) {
            List<LayoutPoint> way = apart(from, to, around(from, to, List.copyOf(met)));
            List<LayoutPoint> line = NetShapes.line(
                    from, to, way); // straight from middle to middle where only a twin's line met something
            List<Vertex> more = met(from, to, line);
            if (more.isEmpty()) {
                way.forEach(bend -> bends.add(new DrawingBox(bend.x(), bend.y(), 0, 0), bend));
                return line;
            }
            if (!met.addAll(more)) {
                return straight;
            }
        }
        return straight;
    }

    private List<Vertex> met(Vertex from, Vertex to, List<LayoutPoint> line) {
        List<Vertex> met = new ArrayList<>();
        for (int i = 1; i < line.size(); i++) {
            LayoutPoint a = line.get(i - 1);
            LayoutPoint b = line.get(i);
            DrawingBox box = new DrawingBox(
                    Math.min(a.x(), b.x()), Math.min(a.y(), b.y()), Math.abs(a.x() - b.x()), Math.abs(a.y() - b.y()));
            for (Vertex vertex : grid.near(box)) {
                if (!vertex.equals(from) && !vertex.equals(to) && isMet(vertex, a, b)) {
                    met.add(vertex);
                }
            }
        }
        return met;
    }

    /** Whether a straight line comes too near to a vertex. */
    static boolean isMet(Vertex vertex, LayoutPoint a, LayoutPoint b) {
        if (vertex.kind() == Kind.TRANSITION) {
            return vertex.box().grown(CLEARANCE).isCrossedBy(a, b);
        }
        double dx = b.x() - a.x();
        double dy = b.y() - a.y();
        double along = ((vertex.centre().x() - a.x()) * dx + (vertex.centre().y() - a.y()) * dy)
                / Math.max(1e-9, dx * dx + dy * dy);
        double part = Math.max(0, Math.min(1, along));
        double distance = Math.hypot(
                a.x() + part * dx - vertex.centre().x(),
                a.y() + part * dy - vertex.centre().y());
        return distance < NetDrawing.PLACE_RADIUS + CLEARANCE;
    }

    /** The corners along which the shortest way leads; empty where there is none. */
    private static List<LayoutPoint> around(Vertex from, Vertex to, List<Vertex> obstacles) {
        List<LayoutPoint> points = new ArrayList<>(List.of(from.centre(), to.centre()));
        for (Vertex vertex : obstacles) {
            DrawingBox box = vertex.box().grown(LANE_OFFSET);
            points.add(new LayoutPoint(box.x(), box.y()));
            points.add(new LayoutPoint(box.maxX(), box.y()));
            points.add(new LayoutPoint(box.x(), box.maxY()));
            points.add(new LayoutPoint(box.maxX(), box.maxY()));
        }
        double[] cost = new double[points.size()];
        int[] before = new int[points.size()];
        boolean[] done = new boolean[points.size()];
        Arrays.fill(cost, Double.MAX_VALUE);
        cost[0] = 0;
        for (int at = 0; at >= 0 && at != 1; at = cheapest(cost, done)) {
            done[at] = true;
            LayoutPoint here = points.get(at);
            for (int next = 1; next < points.size(); next++) {
                LayoutPoint there = points.get(next);
                double length = cost[at] + BEND + Math.hypot(there.x() - here.x(), there.y() - here.y());
                if (!done[next]
                        && length < cost[next]
                        && obstacles.stream().noneMatch(vertex -> isMet(vertex, here, there))) {
                    cost[next] = length;
                    before[next] = at;
                }
            }
        }
        List<LayoutPoint> way = new ArrayList<>();
        for (int at = before[1]; cost[1] < Double.MAX_VALUE && at != 0; at = before[at]) {
            way.add(0, points.get(at));
        }
        return way;
    }

    private static int cheapest(double[] cost, boolean[] done) {
        int best = -1;
        for (int i = 0; i < cost.length; i++) {
            if (!done[i] && cost[i] < Double.MAX_VALUE && (best < 0 || cost[i] < cost[best])) {
                best = i;
            }
        }
        return best;
    }

    /** The same way on a lane of its own, where other lines have bends at the same corners and there is room. */
    private List<LayoutPoint> apart(Vertex from, Vertex to, List<LayoutPoint> way) {
        List<LayoutPoint> found = way;
        for (int lane = 0; lane < LANES; lane++) {
            List<LayoutPoint> moved = outwards(from.centre(), to.centre(), way, lane * NEXT_LANE);
            if (lane > 0 && !met(from, to, NetShapes.line(from, to, moved)).isEmpty()) {
                return found;
            }
            found = moved;
            if (moved.stream().noneMatch(this::isTaken)) {
                return found;
            }
        }
        return found;
    }

    private boolean isTaken(LayoutPoint bend) {
        return bends.near(new DrawingBox(bend.x(), bend.y(), 0, 0)).stream()
                .anyMatch(other -> Math.hypot(other.x() - bend.x(), other.y() - bend.y()) < NEXT_LANE - 1);
    }

    /** Each bend away from the vertex that it leads around: to the outside of the way. */
    private static List<LayoutPoint> outwards(LayoutPoint from, LayoutPoint to, List<LayoutPoint> way, double by) {
        List<LayoutPoint> moved = new ArrayList<>();
        for (int i = 0; i < way.size(); i++) {
            LayoutPoint at = way.get(i);
            LayoutPoint before = i == 0 ? from : way.get(i - 1);
            LayoutPoint after = i == way.size() - 1 ? to : way.get(i + 1);
            double x = unit(at.x() - before.x(), at.y() - before.y()) + unit(at.x() - after.x(), at.y() - after.y());
            double y = unit(at.y() - before.y(), at.x() - before.x()) + unit(at.y() - after.y(), at.x() - after.x());
            double length = Math.max(1e-9, Math.hypot(x, y));
            moved.add(new LayoutPoint(at.x() + by * x / length, at.y() + by * y / length));
        }
        return moved;
    }

    /** The first coordinate of a vector that is made one long. */
    private static double unit(double first, double second) {
        return first / Math.max(1e-9, Math.hypot(first, second));
    }
}
