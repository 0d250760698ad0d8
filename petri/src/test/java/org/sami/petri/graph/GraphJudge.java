package org.sami.petri.graph;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.LongConsumer;
import org.sami.petri.net.PetriNet;

/** Compares the graph of a seed's random net, whole and reduced, and the states from which some others are reached, with those of a plain explorer. */
public final class GraphJudge implements LongConsumer {
    private static final int MOST = 250;
    private static final int KINDS = 3;

    /** Nothing is judged yet. */
    public GraphJudge() {}

    @Override
    public void accept(long seed) {
        PetriNet net = seed % KINDS == 0
                ? RandomNets.net(seed)
                : seed % KINDS == 1 ? RandomNets.loose(seed) : RandomNets.wide(seed);
        PlainExplorer plain = new PlainExplorer(net, MOST);
        SearchSettings few = SearchSettings.within(SearchBudget.ofStates(MOST));
        ReachabilityGraph graph = ReachabilitySearch.explore(net, few.withEdges());
        if (!plain.isComplete()) {
            assertThat(graph.isComplete()).isFalse();
            return;
        }
        whole(graph, plain);
        ReachabilityGraph reduced = ReachabilitySearch.explore(net, few.withReduction());
        assertThat(reduced.isComplete()).isTrue();
        assertThat(deadlocks(reduced)).isEqualTo(deadlocks(graph));
        for (int place = 0; place < net.placeCount(); place++) {
            home(graph, plain, place, 1 + (int) (seed % 2));
        }
    }

    /** Whether a graph has the markings, firings, bounds and shortest runs that it has to have. */
    static void whole(ReachabilityGraph graph, PlainExplorer plain) {
        assertThat(graph.isComplete()).isTrue();
        assertThat(graph.states()).isEqualTo(plain.distances.size());
        assertThat(graph.edges()).isEqualTo(plain.edges());
        assertThat(deadlocks(graph)).hasSize((int) plain.deadlocks());
        for (int place = 0; place < graph.net().placeCount(); place++) {
            assertThat(graph.mostTokens(place)).isEqualTo(plain.most[place]);
        }
        for (int t = 0; t < graph.net().transitionCount(); t++) {
            assertThat(graph.deadTransitions().contains(t)).isNotEqualTo(plain.fired[t]);
        }
        for (int state = 0; state < graph.states(); state++) {
            List<Integer> marking = PlainExplorer.list(graph.marking(state));
            assertThat(plain.successors).containsKey(marking);
            List<List<Integer>> next = Arrays.stream(graph.successors(state))
                    .mapToObj(successor -> PlainExplorer.list(graph.marking(successor)))
                    .toList();
            assertThat(next).containsExactlyInAnyOrderElementsOf(plain.successors.get(marking));
            FiringSequence run = graph.runTo(state);
            assertThat(run.transitions()).hasSize(plain.distances.get(marking));
            assertThat(run.replay(graph.net())).containsExactly(graph.marking(state));
        }
    }

    private static Set<List<Integer>> deadlocks(ReachabilityGraph graph) {
        Set<List<Integer>> markings = new HashSet<>();
        graph.deadlocks().forEach(state -> markings.add(PlainExplorer.list(graph.marking(state))));
        return markings;
    }

    /** Whether the states from which a place can come to so many tokens are those. */
    private static void home(ReachabilityGraph graph, PlainExplorer plain, int place, int tokens) {
        HomeStates states = HomeStates.of(graph, marking -> marking[place] >= tokens);

        Set<List<Integer>> reach = plain.reaching(marking -> marking.get(place) >= tokens);
        assertThat(states.count()).isEqualTo(reach.size());
        assertThat(states.firstWithout().isEmpty()).isEqualTo(reach.size() == plain.distances.size());
        states.firstWithout().ifPresent(state -> {
            List<Integer> first = PlainExplorer.list(graph.marking(state));
            assertThat(reach).doesNotContain(first);
            assertThat(plain.distances.get(first))
                    .isEqualTo(plain.distances.entrySet().stream()
                            .filter(marking -> !reach.contains(marking.getKey()))
                            .mapToInt(Map.Entry::getValue)
                            .min()
                            .orElseThrow());
        });
    }
}
