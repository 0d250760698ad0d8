package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Label;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;

/**
 * Puts labels where no vertex and no other label is: of the free places near what a label speaks of, the one that hides the least of
 * lines and lies nearest.
 */
final class LabelPlacement {
    private static final double GAP = 4;
    private static final double PER_LINE_CROSSED = 26;
    private static final double[] ALONG = {0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74};
    private static final double RING = 12;
    private static final int DIRECTIONS = 16;
    private static final int RINGS = 400;
    private static final int RINGS_AFTER_THE_FIRST = 8;

    private final CellGrid<DrawingBox> taken = new CellGrid<>();
    private final CellGrid<Segment> lines = new CellGrid<>();
    private double bottom = Double.NEGATIVE_INFINITY;
    private final List<Label> placed = new ArrayList<>();

    /** A straight part of an edge. */
    private record Segment(String edge, LayoutPoint from, LayoutPoint to) {
        DrawingBox box() {
            double x = Math.min(from.x(), to.x());
            double y = Math.min(from.y(), to.y());
            return new DrawingBox(x, y, Math.abs(to.x() - from.x()), Math.abs(to.y() - from.y()));
        }
    }

    LabelPlacement(Collection<Vertex> vertices, List<Edge> edges) {
        vertices.forEach(vertex -> take(vertex.box()));
        for (Edge edge : edges) {
            for (int i = 1; i < edge.points().size(); i++) {
                Segment segment = new Segment(
                        edge.id(), edge.points().get(i - 1), edge.points().get(i));
                lines.add(segment.box(), segment, cell -> cell.isCrossedBy(segment.from(), segment.to()));
            }
        }
    }

    /** Keeps labels away from a box. */
    void take(DrawingBox box) {
        DrawingBox grown = box.grown(GAP);
        taken.add(grown, grown);
        bottom = Math.max(bottom, grown.maxY());
    }

    /** Below the vertex, or else above it, at its side, or farther away. */
    void placeAtVertex(Vertex vertex, TextBlock text) {
        DrawingBox box = vertex.box();
        double apart = GAP + 1;
        double left = vertex.centre().x() - text.width() / 2;
        double middle = vertex.centre().y() - text.height() / 2;
        List<LayoutPoint> corners = List.of(
                new LayoutPoint(left, box.maxY() + apart),
                new LayoutPoint(left, box.y() - apart - text.height()),
                new LayoutPoint(box.maxX() + apart, middle),
                new LayoutPoint(box.x() - apart - text.width(), middle));
        place(vertex.id(), text, corners, vertex.centre(), false);
    }

    /** On the line, or else next to it. */
    void placeAtEdge(Edge edge, TextBlock text) {
        List<LayoutPoint> corners = new ArrayList<>();
        for (double part : ALONG) {
            LayoutPoint at = along(edge.points(), part);
            corners.add(new LayoutPoint(at.x() - text.width() / 2, at.y() - text.height() / 2));
        }
        place(edge.id(), text, corners, along(edge.points(), 0.5), true);
    }

    /** The point after a part of the length of a line. */
    private static LayoutPoint along(List<LayoutPoint> points, double part) {
        double length = 0;
        for (int i = 1; i < points.size(); i++) {
            length += distance(points.get(i - 1), points.get(i));
        }
        double left = part * length;
        for (int i = 1; i < points.size(); i++) {
            LayoutPoint from = points.get(i - 1);
            LayoutPoint to = points.get(i);
            double step = distance(from, to);
            if (left <= step || i == points.size() - 1) {
                double share = left / Math.max(1e-9, step);
                return new LayoutPoint(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
            }
            left -= step;
        }
        return points.get(0);
    }

    private static double distance(LayoutPoint a, LayoutPoint b) {
        return Math.hypot(b.x() - a.x(), b.y() - a.y());
    }

    List<Label> placed() {
        return placed;
    }

    private void place(String of, TextBlock text, List<LayoutPoint> preferred, LayoutPoint anchor, boolean onLine) {
        if (text.isEmpty()) {
            return;
        }
        LayoutPoint best = null;
        double least = Double.MAX_VALUE;
        for (int i = 0; i < preferred.size(); i++) {
            double cost = cost(of, text, preferred.get(i), 2.0 * i);
            if (cost < least) {
                least = cost;
                best = preferred.get(i);
            }
        }
        boolean near = best != null;
        int last = near ? RINGS_AFTER_THE_FIRST : RINGS;
        for (int ring = 1; ring <= last && (best == null || ring * RING < least); ring++) {
            for (int i = 0; i < DIRECTIONS; i++) {
                double angle = 2 * Math.PI * i / DIRECTIONS;
                LayoutPoint corner = new LayoutPoint(
                        anchor.x() + (ring * RING + text.width() / 2) * Math.cos(angle) - text.width() / 2,
                        anchor.y() + (ring * RING + text.height() / 2) * Math.sin(angle) - text.height() / 2);
                double cost = cost(of, text, corner, 10 + ring * RING);
                if (cost < least) {
                    least = cost;
                    best = corner;
                    near = false;
                }
            }
        }
        if (best == null) { // below all there is
            best = new LayoutPoint(anchor.x() - text.width() / 2, bottom + 2 * GAP);
            near = false;
        }
        Label label = new Label(of, text, best.x(), best.y(), onLine && near);
        placed.add(label);
        take(label.box());
    }

    /** Infinite where something lies there already. */
    private double cost(String of, TextBlock text, LayoutPoint corner, double distance) {
        DrawingBox box = new DrawingBox(corner.x(), corner.y(), text.width(), text.height());
        if (taken.near(box).stream().anyMatch(box::intersects)) {
            return Double.MAX_VALUE;
        }
        double cost = distance;
        for (Segment segment : lines.near(box)) {
            if (!segment.edge().equals(of) && box.isCrossedBy(segment.from(), segment.to())) {
                cost += PER_LINE_CROSSED;
            }
        }
        return cost;
    }
}
