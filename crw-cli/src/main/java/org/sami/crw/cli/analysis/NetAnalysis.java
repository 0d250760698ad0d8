package org.sami.crw.cli.analysis;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.QueryAnswer;
import org.sami.petri.query.QueryAnswer.NetVerdict;

/**
 * What {@code crw analyse} has found.
 *
 * @param query its text; empty where the whole graph was asked for
 * @param answer to the query; empty where there was none
 */
record NetAnalysis(PetriNet net, ReachabilityGraph graph, String query, Optional<QueryAnswer> answer) {
    /** The whole graph of a net. */
    static NetAnalysis of(ReachabilityGraph graph) {
        return new NetAnalysis(graph.net(), graph, "", Optional.empty());
    }

    /** The answer to a query. */
    static NetAnalysis of(String query, QueryAnswer answer) {
        return new NetAnalysis(answer.graph().net(), answer.graph(), query, Optional.of(answer));
    }

    double seconds() {
        return Math.max(1, graph.nanos()) / 1e9;
    }

    double statesPerSecond() {
        return graph.looked() / seconds();
    }

    double bytesPerState() {
        return (double) graph.bytes() / graph.states();
    }

    /** Whether the budget ended the search before all was known. */
    boolean isOpen() {
        return answer.map(a -> a.verdict() == NetVerdict.UNKNOWN)
                .orElseGet(() -> graph.end().isBounded());
    }

    /** Whether something was found that a query asked about as a fault: a broken invariant, a deadlock, a run that cannot end. */
    boolean hasFound() {
        String kind = query.strip().split("\\s", 2)[0];
        return answer.map(QueryAnswer::verdict)
                .filter(verdict -> kind.equals("deadlock")
                        ? verdict == NetVerdict.YES
                        : verdict == NetVerdict.NO && !kind.equals("reachable"))
                .isPresent();
    }

    /** The run that shows the answer; of a whole graph the one to its nearest deadlock. */
    Optional<FiringSequence> witness() {
        if (answer.isPresent()) {
            return answer.get().witness();
        }
        return graph.deadlocks().stream().findFirst().map(graph::runTo);
    }

    /** The most tokens that any place has. */
    int mostTokens() {
        return IntStream.range(0, net.placeCount()).map(graph::mostTokens).max().orElse(0);
    }

    /** Places with their tokens in a marking, without empty ones. */
    List<String> marked(int[] marking) {
        return IntStream.range(0, marking.length)
                .filter(place -> marking[place] > 0)
                .mapToObj(place -> net.placeId(place) + (marking[place] == 1 ? "" : "*" + marking[place]))
                .toList();
    }
}
