package org.sami.ui.net;

import edu.uci.ics.jung.algorithms.layout.StaticLayout;
import edu.uci.ics.jung.graph.DirectedSparseMultigraph;
import edu.uci.ics.jung.graph.Graph;
import edu.uci.ics.jung.graph.util.EdgeType;
import java.awt.Dimension;
import java.awt.geom.Point2D;
import java.util.HashMap;
import java.util.Map;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.model.Plan;

/** A plan as JUNG's graph: vertices and edges by their ids, where the drawing has them. */
final class NetGraph {
    private NetGraph() {}

    static StaticLayout<String, String> layout(Plan plan, NetDrawing drawing) {
        Graph<String, String> graph = new DirectedSparseMultigraph<>();
        Map<String, Point2D> centres = new HashMap<>();
        drawing.vertices().forEach(vertex -> {
            graph.addVertex(vertex.id());
            centres.put(
                    vertex.id(),
                    new Point2D.Double(vertex.centre().x(), vertex.centre().y()));
        });
        plan.inEdges().forEach(edge -> graph.addEdge(edge.id(), edge.place(), edge.transition(), EdgeType.DIRECTED));
        plan.outEdges().forEach(edge -> graph.addEdge(edge.id(), edge.transition(), edge.place(), EdgeType.DIRECTED));
        DrawingBox bounds = drawing.bounds();
        return new StaticLayout<>(
                graph, centres::get, new Dimension((int) bounds.width() + 1, (int) bounds.height() + 1));
    }
}
