package org.sami.crw.cli.analysis;

import org.sami.petri.graph.ReachabilityGraph;

/** How fast a search was, and how much memory it took. */
record SearchSpeed(double seconds, double statesPerSecond, double bytesPerState) {
    static SearchSpeed of(ReachabilityGraph graph) {
        double seconds = Math.max(1, graph.nanos()) / 1e9;
        return new SearchSpeed(seconds, graph.looked() / seconds, (double) graph.bytes() / graph.states());
    }
}
