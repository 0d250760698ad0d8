package org.sami.ui.net;

import edu.uci.ics.jung.algorithms.cluster.WeakComponentClusterer;
import edu.uci.ics.jung.algorithms.filters.FilterUtils;
import edu.uci.ics.jung.graph.DirectedSparseMultigraph;
import edu.uci.ics.jung.graph.Graph;
import edu.uci.ics.jung.graph.util.EdgeType;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sami.spn.model.Plan;

/** A plan as JUNG's graph: vertices and edges by their ids. */
final class NetGraph {
    private NetGraph() {}

    static Graph<String, String> of(Plan plan) {
        Graph<String, String> graph = new DirectedSparseMultigraph<>();
        plan.places().forEach(place -> graph.addVertex(place.id()));
        plan.transitions().forEach(transition -> graph.addVertex(transition.id()));
        plan.inEdges().forEach(edge -> graph.addEdge(edge.id(), edge.place(), edge.transition(), EdgeType.DIRECTED));
        plan.outEdges().forEach(edge -> graph.addEdge(edge.id(), edge.transition(), edge.place(), EdgeType.DIRECTED));
        return graph;
    }

    /** The parts of a graph that no edge connects, in the order of their first vertices. */
    static List<Graph<String, String>> components(Graph<String, String> graph, List<String> order) {
        Set<Set<String>> parts = new WeakComponentClusterer<String, String>().apply(graph);
        List<Graph<String, String>> components = new ArrayList<>();
        order.stream()
                .map(id -> parts.stream()
                        .filter(part -> part.contains(id))
                        .findFirst()
                        .orElseThrow())
                .distinct()
                .forEach(part -> components.add(FilterUtils.createInducedSubgraph(
                        order.stream().filter(part::contains).toList(), graph)));
        return components;
    }
}
