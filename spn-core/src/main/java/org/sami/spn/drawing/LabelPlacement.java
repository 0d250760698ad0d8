package org.sami.crw.sim.drawing;

import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.sami.crw.sim.drawing.NetDrawing.Edge;
import org.sami.crw.sim.drawing.NetDrawing.Label;
import org.sami.crw.sim.drawing.NetDrawing.Vertex;

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

    private final List<Rectangle2D> taken = new ArrayList<>();
    private final List<Edge> edges;
    private final List<Label> placed = new ArrayList<>();

    LabelPlacement(Collection<Vertex> vertices, List<Edge> edges) {
        vertices.forEach(vertex -> taken.add(grown(vertex.box())));
        this.edges = edges;
    }

    /** Below the vertex, or else above, beside it, or farther away. */
    void placeAtVertex(Vertex vertex, TextBlock text) {
        Rectangle2D box = vertex.box();
        double apart = GAP + 1;
        double left = vertex.centre().getX() - text.width() / 2;
        double middle = vertex.centre().getY() - text.height() / 2;
        List<Point2D> corners = List.of(
                new Point2D.Double(left, box.getMaxY() + apart),
                new Point2D.Double(left, box.getMinY() - apart - text.height()),
                new Point2D.Double(box.getMaxX() + apart, middle),
                new Point2D.Double(box.getMinX() - apart - text.width(), middle));
        place(vertex.id(), text, corners, vertex.centre(), false);
    }

    /** On the line, or else beside it. */
    void placeAtEdge(Edge edge, TextBlock text) {
        Point2D from = edge.points().get(0);
        Point2D to = edge.points().get(edge.points().size() - 1);
        List<Point2D> corners = new ArrayList<>();
        for (double part : ALONG) {
            double x = from.getX() + part * (to.getX() - from.getX());
            double y = from.getY() + part * (to.getY() - from.getY());
            corners.add(new Point2D.Double(x - text.width() / 2, y - text.height() / 2));
        }
        Point2D middle = new Point2D.Double((from.getX() + to.getX()) / 2, (from.getY() + to.getY()) / 2);
        place(edge.id(), text, corners, middle, true);
    }

    List<Label> placed() {
        return placed;
    }

    private void place(String of, TextBlock text, List<Point2D> preferred, Point2D anchor, boolean onLine) {
        if (text.isEmpty()) {
            return;
        }
        Point2D best = null;
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
                Point2D corner = new Point2D.Double(
                        anchor.getX() + (ring * RING + text.width() / 2) * Math.cos(angle) - text.width() / 2,
                        anchor.getY() + (ring * RING + text.height() / 2) * Math.sin(angle) - text.height() / 2);
                double cost = cost(of, text, corner, 10 + ring * RING);
                if (cost < least) {
                    least = cost;
                    best = corner;
                    near = false;
                }
            }
        }
        if (best == null) { // below all there is
            double bottom =
                    taken.stream().mapToDouble(Rectangle2D::getMaxY).max().orElse(0);
            best = new Point2D.Double(anchor.getX() - text.width() / 2, bottom + 2 * GAP);
            near = false;
        }
        Label label = new Label(of, text, best.getX(), best.getY(), onLine && near);
        placed.add(label);
        taken.add(grown(label.box()));
    }

    private static Rectangle2D grown(Rectangle2D box) {
        return new Rectangle2D.Double(
                box.getX() - GAP, box.getY() - GAP, box.getWidth() + 2 * GAP, box.getHeight() + 2 * GAP);
    }

    /** Infinite where something lies there already. */
    private double cost(String of, TextBlock text, Point2D corner, double distance) {
        Rectangle2D box = new Rectangle2D.Double(corner.getX(), corner.getY(), text.width(), text.height());
        if (taken.stream().anyMatch(box::intersects)) {
            return Double.MAX_VALUE;
        }
        double cost = distance;
        for (Edge edge : edges) {
            if (!edge.id().equals(of)) {
                for (int i = 1; i < edge.points().size(); i++) {
                    if (box.intersectsLine(new Line2D.Double(
                            edge.points().get(i - 1), edge.points().get(i)))) {
                        cost += PER_LINE_CROSSED;
                    }
                }
            }
        }
        return cost;
    }
}
