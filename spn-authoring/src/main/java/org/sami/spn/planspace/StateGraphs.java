package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilityGraph.StateFiring;
import org.sami.spn.drawing.states.StateGraph;

/** Puts a reachability graph into words, to be drawn. */
public final class StateGraphs {
    private final ReachabilityGraph graph;
    private final StateWords words;
    private final Set<Integer> deadlocks;

    private StateGraphs(ReachabilityGraph graph, StateWords words) {
        this.graph = graph;
        this.words = words;
        deadlocks = graph.deadlocks().stream().collect(Collectors.toSet());
    }

    /**
     * The states that a search has found, with the firings between them. The numbers of states stay.
     *
     * @param title what was searched
     * @param isSymmetric whether states that are alike are one, for the line below the title
     */
    public static StateGraph of(ReachabilityGraph graph, String title, boolean isSymmetric, StateWords words) {
        StateGraphs all = new StateGraphs(graph, words);
        List<StateGraph.State> states = new ArrayList<>();
        List<StateGraph.Arrow> arrows = new ArrayList<>();
        for (int state = 0; state < graph.states(); state++) {
            states.add(all.state(state));
            arrows.addAll(all.arrows(state));
        }
        return new StateGraph(title, remark(graph, isSymmetric), states, arrows);
    }

    /** How much of the graph was found, in words. */
    public static String remark(ReachabilityGraph graph, boolean isSymmetric) {
        String alike = isSymmetric ? " up to symmetry" : "";
        return graph.isComplete()
                ? "all " + graph.states() + " states" + alike
                : "the nearest " + graph.states() + " states" + alike + ", " + (graph.states() - graph.looked())
                        + " of them not followed (dashed): bounded search only, as "
                        + graph.end().words();
    }

    private StateGraph.State state(int state) {
        int[] marking = graph.marking(state);
        StateGraph.Kind kind = kind(state, marking);
        String name = switch (kind) {
            case DEADLOCK -> state + " · deadlock";
            case END -> state + " · end";
            case INNER, NOT_FOLLOWED -> String.valueOf(state);
        };
        List<String> marked = words.marked(marking);
        return new StateGraph.State(name, marked.isEmpty() ? List.of("(no token)") : marked, kind);
    }

    private StateGraph.Kind kind(int state, int[] marking) {
        if (deadlocks.contains(state)) {
            return words.isEnd(marking) ? StateGraph.Kind.END : StateGraph.Kind.DEADLOCK;
        }
        return state < graph.looked() ? StateGraph.Kind.INNER : StateGraph.Kind.NOT_FOLLOWED;
    }

    /** One arrow for each state that follows, with all firings that lead there. */
    private List<StateGraph.Arrow> arrows(int state) {
        Map<Integer, List<String>> byTarget = new LinkedHashMap<>();
        for (StateFiring firing : graph.firings(state)) {
            byTarget.computeIfAbsent(firing.target(), target -> new ArrayList<>())
                    .add(words.firing(firing.transition()));
        }
        List<StateGraph.Arrow> arrows = new ArrayList<>();
        byTarget.forEach((target, firings) -> arrows.add(new StateGraph.Arrow(state, target, firings)));
        return arrows;
    }
}
