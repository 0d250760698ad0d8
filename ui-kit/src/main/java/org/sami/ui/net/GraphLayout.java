package org.sami.ui.net;

import edu.uci.ics.jung.algorithms.layout.AbstractLayout;
import edu.uci.ics.jung.algorithms.layout.FRLayout;
import edu.uci.ics.jung.algorithms.layout.KKLayout;
import edu.uci.ics.jung.algorithms.layout.util.RandomLocationTransformer;
import edu.uci.ics.jung.algorithms.util.IterativeContext;
import edu.uci.ics.jung.graph.Graph;
import java.awt.Dimension;
import java.awt.geom.Point2D;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;

/**
 * JUNG's layouts of a net. Parts that no edge connects are laid out on their own, from left to right. A layout begins at random points with a fixed
 * seed, so that equal nets are laid out equally.
 */
public enum GraphLayout {
    /** After Fruchterman and Reingold: edges draw together, vertices push apart. */
    FORCES {
        @Override
        AbstractLayout<String, String> layout(Graph<String, String> graph, Dimension size) {
            return new Forces(graph, size);
        }
    },
    /** After Kamada and Kawai: vertices are as far apart as there are edges between them. */
    DISTANCES {
        @Override
        AbstractLayout<String, String> layout(Graph<String, String> graph, Dimension size) {
            KKLayout<String, String> layout = new KKLayout<>(graph);
            layout.setSize(size);
            layout.setMaxIterations(STEPS);
            return layout;
        }
    };

    private static final double ROOM = 190; // that a vertex with its words takes in both directions
    private static final double SHAPE = 1.6; // wider than high, as windows are
    private static final int STEPS = 500;

    abstract AbstractLayout<String, String> layout(Graph<String, String> graph, Dimension size);

    /**
     * The centres of all vertices, in drawing units.
     *
     * @param drawing of the plan, with the present positions
     * @param cancelled is asked again and again, on the caller's thread
     * @throws CancellationException when it was cancelled
     */
    public Map<String, LayoutPoint> of(Plan plan, NetDrawing drawing, BooleanSupplier cancelled) {
        List<String> order = drawing.vertices().stream().map(Vertex::id).toList();
        Map<String, LayoutPoint> centres = new LinkedHashMap<>();
        double left = 0;
        for (Graph<String, String> part : NetGraph.components(NetGraph.of(plan), order)) {
            List<String> vertices = order.stream().filter(part::containsVertex).toList();
            Map<String, Point2D> points = points(part, vertices, plan.id().hashCode(), cancelled);
            double scale = Math.max(1, ROOM / meanLength(part, points));
            double from =
                    points.values().stream().mapToDouble(Point2D::getX).min().orElse(0);
            double top =
                    points.values().stream().mapToDouble(Point2D::getY).min().orElse(0);
            double right = left;
            for (String id : vertices) {
                Point2D point = at(points, id);
                double x = left + scale * (point.getX() - from);
                centres.put(id, new LayoutPoint(x, scale * (point.getY() - top)));
                right = Math.max(right, x);
            }
            left = right + ROOM;
        }
        return centres;
    }

    private Map<String, Point2D> points(
            Graph<String, String> graph, List<String> vertices, long seed, BooleanSupplier cancelled) {
        double height = ROOM * Math.sqrt(Math.max(1, vertices.size()) / SHAPE);
        Dimension size = new Dimension((int) (height * SHAPE), (int) height);
        RandomLocationTransformer<String> spread = new RandomLocationTransformer<>(size, seed);
        Map<String, Point2D> points = new HashMap<>();
        vertices.forEach(id -> points.put(id, spread.apply(id)));
        if (vertices.size() > 1) {
            AbstractLayout<String, String> layout = layout(graph, size);
            layout.setInitializer(id -> at(points, id));
            layout.initialize();
            IterativeContext steps = (IterativeContext) layout;
            while (!steps.done()) {
                if (cancelled.getAsBoolean()) {
                    throw new CancellationException("the layout was cancelled");
                }
                steps.step();
            }
            vertices.forEach(id -> points.put(id, layout.apply(id)));
        }
        return points;
    }

    private static Point2D at(Map<String, Point2D> points, String vertex) {
        return Objects.requireNonNull(points.get(vertex), vertex);
    }

    /** How long edges are on average; as long as a vertex takes where there are none. */
    private static double meanLength(Graph<String, String> graph, Map<String, Point2D> points) {
        return Math.max(
                1,
                graph.getEdges().stream()
                        .mapToDouble(
                                edge -> at(points, graph.getSource(edge)).distance(at(points, graph.getDest(edge))))
                        .average()
                        .orElse(ROOM));
    }

    /** JUNG's layout by forces without its frame: what reaches the frame, JUNG puts at a random point of the process. */
    private static final class Forces extends FRLayout<String, String> {
        private double reach; // of a step, which becomes shorter
        private int steps;

        Forces(Graph<String, String> graph, Dimension size) {
            super(graph, size);
            setMaxIterations(STEPS);
            reach = size.width / 10.0;
        }

        @Override
        public synchronized void step() {
            super.step();
            steps++;
            reach *= 1 - (double) steps / STEPS;
        }

        @Override
        protected synchronized void calcPositions(String vertex) {
            Point2D force = getFRData(vertex);
            Point2D at = apply(vertex);
            double length = Math.max(1e-6, Math.hypot(force.getX(), force.getY()));
            double part = Math.min(length, reach) / length;
            at.setLocation(at.getX() + part * force.getX(), at.getY() + part * force.getY());
        }
    }
}
