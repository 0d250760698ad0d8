package org.sami.petri.symmetry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.LongConsumer;
import java.util.stream.IntStream;
import org.sami.petri.graph.PlainExplorer;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.PetriNet;

/** Compares what is said from one of all states that are alike, for a seed's random net of parts that are or seem alike, with all states. */
public final class SymmetryJudge implements LongConsumer {
    private static final int MOST = 300;
    private static final int KINDS = 5;

    /** Nothing is judged yet. */
    public SymmetryJudge() {}

    @Override
    public void accept(long seed) {
        int kind = (int) (seed % KINDS);
        PetriNet net = switch (kind) {
            case 0 -> CopiedNets.regular(seed);
            case 1 -> CopiedNets.ring(seed);
            case 2 -> CopiedNets.net(seed);
            default -> CopiedNets.nearly(seed / KINDS);
        };
        PlainExplorer plain = new PlainExplorer(net, MOST);
        if (plain.isComplete()) {
            NetSymmetry symmetry = kind == 3 ? NetSymmetry.of(net, CopiedNets.exchanges(net)) : NetSymmetry.of(net);
            compare(net, symmetry, plain, SearchSettings.within(SearchBudget.ofStates(MOST)));
        }
    }

    private static void compare(PetriNet net, NetSymmetry symmetry, PlainExplorer plain, SearchSettings settings) {
        ReachabilityGraph alike = ReachabilitySearch.explore(net, settings.withSymmetry(symmetry));
        assertThat(alike.isComplete()).isTrue();
        Set<List<Integer>> normal = new HashSet<>();
        Set<List<Integer>> deadlocks = new HashSet<>();
        plain.successors.forEach((marking, next) -> {
            List<Integer> standsForIt = normal(
                    symmetry, marking.stream().mapToInt(Integer::intValue).toArray());
            normal.add(standsForIt);
            if (next.isEmpty()) {
                deadlocks.add(standsForIt);
            }
        });
        Set<List<Integer>> found = new HashSet<>();
        for (int state = 0; state < alike.states(); state++) {
            assertThat(plain.distances).containsKey(PlainExplorer.list(alike.marking(state)));
            found.add(normal(symmetry, alike.marking(state)));
            int[] reached = alike.runTo(state).replay(net);
            assertThat(alike.runTo(state).transitions()).hasSize(plain.distances.get(PlainExplorer.list(reached)));
            assertThat(normal(symmetry, reached)).isEqualTo(normal(symmetry, alike.marking(state)));
        }
        assertThat(found).isEqualTo(normal);
        assertThat(deadlocks(alike, symmetry)).isEqualTo(deadlocks);
        assertThat(deadlocks(
                        ReachabilitySearch.explore(
                                net, settings.withSymmetry(symmetry).withReduction()),
                        symmetry))
                .isEqualTo(deadlocks);
        for (int place = 0; place < net.placeCount(); place++) {
            assertThat(alike.mostTokens(place)).isEqualTo(plain.most[place]);
        }
        for (int t = 0; t < net.transitionCount(); t++) {
            assertThat(alike.deadTransitions().contains(t)).isNotEqualTo(plain.fired[t]);
        }
    }

    private static Set<List<Integer>> deadlocks(ReachabilityGraph graph, NetSymmetry symmetry) {
        Set<List<Integer>> normal = new HashSet<>();
        graph.deadlocks().forEach(state -> normal.add(normal(symmetry, graph.marking(state))));
        return normal;
    }

    /** What stands for all markings into which the permutations turn one: the first of them all, not the one that the search takes, which need not be one alone. */
    private static List<Integer> normal(NetSymmetry symmetry, int[] marking) {
        List<Integer> first = PlainExplorer.list(marking);
        Set<List<Integer>> all = new HashSet<>(Set.of(first));
        Deque<List<Integer>> open = new ArrayDeque<>(all);
        while (!open.isEmpty()) {
            List<Integer> one = open.poll();
            first = compare(one, first) < 0 ? one : first;
            for (int generator = 0; generator < symmetry.generators(); generator++) {
                int at = generator;
                List<Integer> other = IntStream.range(0, one.size())
                        .mapToObj(place -> one.get(symmetry.imagesOfPlace(place).get(at)))
                        .toList();
                if (all.add(other)) {
                    open.add(other);
                }
            }
        }
        return first;
    }

    private static int compare(List<Integer> one, List<Integer> other) {
        return Arrays.compare(one.toArray(Integer[]::new), other.toArray(Integer[]::new));
    }
}
