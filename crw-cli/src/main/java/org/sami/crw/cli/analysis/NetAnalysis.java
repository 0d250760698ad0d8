package org.sami.crw.cli.analysis;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.petri.coverability.CoverabilityQueries;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.structure.StructuralProof;
import org.sami.petri.structure.StructuralQueries;

/**
 * What {@code crw analyse} has found.
 *
 * @param graph what was searched; empty where no search was needed
 * @param answer to a query; empty where the whole graph was asked for
 */
record NetAnalysis(PetriNet net, Optional<ReachabilityGraph> graph, Optional<Answered> answer) {
    /**
     * A query with its answer.
     *
     * @param text of the query
     * @param witness a run that shows it
     * @param proof from the structure of the net; empty where a search has answered
     */
    record Answered(
            String text,
            NetQuery query,
            NetVerdict verdict,
            String words,
            Optional<FiringSequence> witness,
            Optional<StructuralProof> proof) {}

    /** The whole graph of a net. */
    static NetAnalysis of(ReachabilityGraph graph) {
        return new NetAnalysis(graph.net(), Optional.of(graph), Optional.empty());
    }

    /** The answer of a search. */
    static NetAnalysis of(String text, NetQuery query, QueryAnswer answer) {
        return new NetAnalysis(
                answer.graph().net(),
                Optional.of(answer.graph()),
                Optional.of(new Answered(
                        text, query, answer.verdict(), answer.words(), answer.witness(), Optional.empty())));
    }

    /** An answer from the structure of a net. */
    static NetAnalysis of(PetriNet net, String text, NetQuery query, StructuralQueries.Answer answer) {
        String words = "proved by " + answer.proof().method().words();
        return new NetAnalysis(
                net,
                Optional.empty(),
                Optional.of(new Answered(
                        text, query, answer.verdict(), words, Optional.empty(), Optional.of(answer.proof()))));
    }

    /** An answer from the coverability set of a net. */
    static NetAnalysis of(PetriNet net, String text, NetQuery query, CoverabilityQueries.Answer answer) {
        return new NetAnalysis(
                net,
                Optional.empty(),
                Optional.of(new Answered(
                        text, query, answer.verdict(), answer.words(), Optional.empty(), Optional.empty())));
    }

    /** Whether the budget ended the search before all was known. */
    boolean isOpen() {
        return answer.map(a -> a.verdict() == NetVerdict.UNKNOWN)
                .orElseGet(() -> graph.filter(g -> g.end().isBounded()).isPresent());
    }

    /** Whether something was found that a query asked about as a fault: a broken invariant, a deadlock, a run that cannot come home, an unbounded place. */
    boolean hasFound() {
        return answer.filter(a -> a.query().isFault(a.verdict())).isPresent();
    }

    /** The run that shows the answer; of a whole graph the one to its nearest deadlock. */
    Optional<FiringSequence> witness() {
        if (answer.isPresent()) {
            return answer.get().witness();
        }
        return graph.flatMap(g -> g.deadlocks().stream().findFirst().map(g::runTo));
    }

    /** Places with their tokens in a marking, without empty ones. */
    List<String> marked(int[] marking) {
        return IntStream.range(0, marking.length)
                .filter(place -> marking[place] > 0)
                .mapToObj(place -> net.placeId(place) + (marking[place] == 1 ? "" : "*" + marking[place]))
                .toList();
    }
}
