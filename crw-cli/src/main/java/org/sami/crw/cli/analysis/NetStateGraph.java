package org.sami.crw.cli.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilityGraph.StateFiring;
import org.sami.petri.net.PetriNet;
import org.sami.spn.drawing.states.StateGraph;

/** The reachability graph of a net in words, to be drawn. */
final class NetStateGraph {
    private final ReachabilityGraph graph;
    private final PetriNet net;

    private NetStateGraph(ReachabilityGraph graph) {
        this.graph = graph;
        net = graph.net();
    }

    /**
     * The states that a search has found, with the firings between them.
     *
     * @param title what was searched
     * @param remark a line about it
     */
    static StateGraph of(ReachabilityGraph graph, String title, String remark) {
        NetStateGraph words = new NetStateGraph(graph);
        List<StateGraph.State> states = new ArrayList<>();
        List<StateGraph.Arrow> arrows = new ArrayList<>();
        for (int state = 0; state < graph.states(); state++) {
            states.add(words.state(state));
            arrows.addAll(words.arrows(state));
        }
        return new StateGraph(title, remark, states, arrows);
    }

    private StateGraph.State state(int state) {
        int[] marking = graph.marking(state);
        List<String> marked = IntStream.range(0, marking.length)
                .filter(place -> marking[place] > 0)
                .mapToObj(place -> net.placeName(place) + (marking[place] == 1 ? "" : "*" + marking[place]))
                .toList();
        boolean isDeadlock = graph.deadlocks().contains(state);
        String name = isDeadlock ? state + " · deadlock" : String.valueOf(state);
        return new StateGraph.State(name, marked.isEmpty() ? List.of("(no token)") : marked, kind(state, isDeadlock));
    }

    private StateGraph.Kind kind(int state, boolean isDeadlock) {
        if (isDeadlock) {
            return StateGraph.Kind.DEADLOCK;
        }
        return state < graph.looked() ? StateGraph.Kind.INNER : StateGraph.Kind.NOT_FOLLOWED;
    }

    /** One arrow for each state that follows, with all firings that lead there. */
    private List<StateGraph.Arrow> arrows(int state) {
        Map<Integer, List<String>> byTarget = new LinkedHashMap<>();
        for (StateFiring firing : graph.firings(state)) {
            byTarget.computeIfAbsent(firing.target(), target -> new ArrayList<>())
                    .add(net.transitionName(firing.transition()));
        }
        List<StateGraph.Arrow> arrows = new ArrayList<>();
        byTarget.forEach((target, firings) -> arrows.add(new StateGraph.Arrow(state, target, firings)));
        return arrows;
    }
}
