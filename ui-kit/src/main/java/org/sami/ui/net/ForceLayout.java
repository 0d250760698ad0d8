package org.sami.ui.net;

import edu.uci.ics.jung.algorithms.layout.FRLayout;
import edu.uci.ics.jung.algorithms.layout.util.RandomLocationTransformer;
import edu.uci.ics.jung.graph.Graph;
import java.awt.Dimension;
import java.awt.geom.Point2D;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;

/**
 * Lays a net out by forces (JUNG's layout after Fruchterman and Reingold): edges draw together, vertices push apart. It begins at random
 * points with a fixed seed, so that equal nets are laid out equally.
 */
public final class ForceLayout {
    private static final double VERTEX_EXTENT = 190; // that a vertex with its words takes in both directions
    private static final double ASPECT_RATIO = 1.6; // wider than high, as windows are
    private static final int STEPS = 500;

    private ForceLayout() {}

    /**
     * The centres of all vertices, in drawing units.
     *
     * @param drawing of the plan, with the present positions
     * @param cancelled is asked again and again, on the caller's thread
     * @throws CancellationException when it was cancelled
     */
    public static Map<String, LayoutPoint> of(Plan plan, NetDrawing drawing, BooleanSupplier cancelled) {
        Graph<String, String> graph = NetGraph.layout(plan, drawing).getGraph();
        double height = VERTEX_EXTENT * Math.sqrt(Math.max(1, graph.getVertexCount()) / ASPECT_RATIO);
        Dimension size = new Dimension((int) (height * ASPECT_RATIO), (int) height);
        Map<String, Point2D> begin = new HashMap<>();
        RandomLocationTransformer<String> spread =
                new RandomLocationTransformer<>(size, plan.id().hashCode());
        drawing.vertices().forEach(vertex -> begin.put(vertex.id(), spread.apply(vertex.id())));
        FRLayout<String, String> layout = new FRLayout<>(graph, size);
        layout.setInitializer(begin::get);
        layout.setMaxIterations(STEPS);
        layout.initialize();
        while (!layout.done()) {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException("the layout was cancelled");
            }
            layout.step();
        }
        Map<String, LayoutPoint> centres = new LinkedHashMap<>();
        drawing.vertices().forEach(vertex -> {
            Point2D at = layout.apply(vertex.id());
            centres.put(vertex.id(), new LayoutPoint(at.getX(), at.getY()));
        });
        return centres;
    }
}
