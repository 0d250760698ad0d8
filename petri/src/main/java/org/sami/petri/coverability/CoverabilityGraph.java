package org.sami.petri.coverability;

import java.util.ArrayList;
import java.util.List;
import org.sami.petri.net.PetriNet;

/**
 * The graph on the markings of a minimal coverability set: from each marking one edge for each transition that is enabled in it, to a marking that covers the one after
 * the firing. Where the set is not complete, firings whose marking nothing covers have no edge.
 *
 * <p>Source: Finkel, "The minimal coverability graph for Petri nets", Advances in Petri Nets 1993, LNCS 674.
 *
 * @param nodes how many markings there are; numbered as in the set
 */
public record CoverabilityGraph(int nodes, List<Edge> edges) {
    public CoverabilityGraph {
        edges = List.copyOf(edges);
    }

    /** A firing between two markings of the set, by their numbers. */
    public record Edge(int from, int transition, int to) {}

    static CoverabilityGraph of(PetriNet net, MarkingOrder order, List<int[]> markings) {
        MaximalMarkings maximal = new MaximalMarkings(order, markings);
        for (int node = 0; node < markings.size(); node++) {
            maximal.add(node, covered -> {
                throw new IllegalStateException("marking " + covered + " of a minimal set is covered by another");
            });
        }
        List<Edge> edges = new ArrayList<>();
        for (int node = 0; node < markings.size(); node++) {
            for (int transition = 0; transition < net.transitionCount(); transition++) {
                if (Omega.isEnabled(net, transition, markings.get(node))) {
                    int to = maximal.covering(Omega.fire(net, transition, markings.get(node)));
                    if (to >= 0) {
                        edges.add(new Edge(node, transition, to));
                    }
                }
            }
        }
        return new CoverabilityGraph(markings.size(), edges);
    }
}
