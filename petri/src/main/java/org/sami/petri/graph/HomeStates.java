package org.sami.petri.graph;

import java.util.BitSet;
import java.util.OptionalInt;

/**
 * From which states of a graph a condition can still be reached, found backwards over the kept edges. Takes four bytes an edge and as many a state, and time
 * that grows with both.
 */
public final class HomeStates {
    /** The longest array has about so many elements. */
    private static final int MOST_EDGES = Integer.MAX_VALUE - 8;

    private final BitSet canReach;
    private final int states;

    private HomeStates(BitSet canReach, int states) {
        this.canReach = canReach;
        this.states = states;
    }

    /** How many bytes the search takes. */
    private static long bytes(ReachabilityGraph graph) {
        return Integer.BYTES * (graph.edges() + 3L * graph.states());
    }

    /** Whether the search fits into so many bytes together with the graph, and an array holds the edges. */
    public static boolean fits(ReachabilityGraph graph, long bytes) {
        return graph.bytes() + bytes(graph) <= bytes
                && graph.keptEdges().map(StateEdges::size).orElse(0L) <= MOST_EDGES;
    }

    /**
     * Finds the states.
     *
     * @param graph a complete graph with its edges
     * @throws IllegalArgumentException if the graph is not complete, has no edges, or has more of them than an array holds
     */
    public static HomeStates of(ReachabilityGraph graph, MarkingTest condition) {
        StateEdges edges =
                graph.keptEdges().orElseThrow(() -> new IllegalArgumentException("the search kept no edges"));
        if (!graph.isComplete() || edges.size() > MOST_EDGES) {
            throw new IllegalArgumentException("the graph is not complete, or has too many edges: " + edges.size());
        }
        int states = graph.states();
        int[] starts = new int[states + 1];
        for (long edge = 0; edge < edges.size(); edge++) {
            starts[edges.target(edge) + 1]++;
        }
        for (int state = 0; state < states; state++) {
            starts[state + 1] += starts[state];
        }
        int[] sources = sources(edges, starts, states);
        BitSet reached = new BitSet(states);
        int[] open = new int[states];
        int waiting = 0;
        for (int state = 0; state < states; state++) {
            if (graph.fulfils(state, condition)) {
                reached.set(state);
                open[waiting++] = state;
            }
        }
        while (waiting > 0) {
            int state = open[--waiting];
            for (int i = starts[state]; i < starts[state + 1]; i++) {
                if (!reached.get(sources[i])) {
                    reached.set(sources[i]);
                    open[waiting++] = sources[i];
                }
            }
        }
        return new HomeStates(reached, states);
    }

    private static int[] sources(StateEdges edges, int[] starts, int states) {
        int[] next = starts.clone();
        int[] sources = new int[(int) edges.size()];
        for (int state = 0; state < states; state++) {
            for (long edge = edges.from(state); edge < edges.to(state); edge++) {
                sources[next[edges.target(edge)]++] = state;
            }
        }
        return sources;
    }

    /** The state nearest to the initial one from which the condition can be reached no more; empty where there is none. */
    public OptionalInt firstWithout() {
        int state = canReach.nextClearBit(0);
        return state < states ? OptionalInt.of(state) : OptionalInt.empty();
    }

    /** From how many states the condition can be reached. */
    public int count() {
        return canReach.cardinality();
    }
}
