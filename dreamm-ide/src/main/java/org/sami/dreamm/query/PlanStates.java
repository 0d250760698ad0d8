package org.sami.dreamm.query;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.symmetry.NetSymmetry;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.states.StateGraph;
import org.sami.spn.drawing.states.StateGraphDrawing;
import org.sami.spn.drawing.states.StateGraphLayout;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanStateWords;
import org.sami.spn.planspace.StateGraphs;

/**
 * The nearest states of a plan, up to an exchange of robots, drawn in layers. Immutable.
 *
 * @param markings of the states
 * @param fired for each arrow ids of the plan's transitions, any of which leads along it
 */
record PlanStates(StateGraphDrawing drawing, List<PlanMarking> markings, List<Set<String>> fired) {
    private static final int MOST_STATES = 120;
    private static final long MOST_BYTES = 64L << 20;
    private static final Duration LONGEST = Duration.ofSeconds(20);

    PlanStates {
        markings = List.copyOf(markings);
        fired = List.copyOf(fired);
    }

    /**
     * Searches and draws, which may take seconds.
     *
     * @throws java.util.concurrent.CancellationException when it was cancelled while it was drawn
     */
    static PlanStates of(PlanNetRequest request, BooleanSupplier isCancelled) throws PlanNetTooLargeException {
        PlanNet net = PlanNet.of(request);
        NetSymmetry symmetry = NetSymmetry.of(net.net(), net.exchanges());
        GraphWatch watch = new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {
                // so few states are found at once
            }

            @Override
            public boolean isCancelled() {
                return isCancelled.getAsBoolean();
            }
        };
        SearchSettings settings = SearchSettings.within(new SearchBudget(MOST_STATES, MOST_BYTES, LONGEST));
        ReachabilityGraph graph = ReachabilitySearch.explore(
                net.net(), symmetry.isEmpty() ? settings : settings.withSymmetry(symmetry), watch, System::nanoTime);
        StateGraph words = StateGraphs.of(graph, "", !symmetry.isEmpty(), new PlanStateWords(net));
        List<Set<String>> fired = new ArrayList<>();
        for (StateGraph.Arrow arrow : words.arrows()) {
            fired.add(graph.firings(arrow.from()).stream()
                    .filter(firing -> firing.target() == arrow.to())
                    .map(firing -> net.firing(firing.transition()).transition())
                    .collect(Collectors.toSet()));
        }
        return new PlanStates(
                StateGraphLayout.of(words, NetFonts::width, isCancelled),
                IntStream.range(0, graph.states())
                        .mapToObj(state -> net.marking(graph.marking(state)))
                        .toList(),
                fired);
    }
}
