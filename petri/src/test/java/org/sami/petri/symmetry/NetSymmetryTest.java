package org.sami.petri.symmetry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.model.ExampleNetNames;
import org.sami.petri.model.ExampleNets;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

class NetSymmetryTest {
    private static final SearchSettings WHOLE = SearchSettings.within(SearchBudget.ofStates(2_000_000));

    private static ReachabilityGraph quotient(PetriNet net) {
        return ReachabilitySearch.explore(net, WHOLE.withSymmetry(NetSymmetry.of(net)));
    }

    /** The states of the whole graph with each of them replaced by the one that stands for it: what is left of them. */
    private static int divided(PetriNet net) {
        ReachabilityGraph whole = ReachabilitySearch.explore(net, WHOLE);
        NetSymmetry symmetry = NetSymmetry.of(net);
        Set<List<Integer>> representatives = new HashSet<>();
        for (int state = 0; state < whole.states(); state++) {
            int[] marking = whole.marking(state);
            symmetry.normalize(marking);
            representatives.add(IntStream.of(marking).boxed().toList());
        }
        return representatives.size();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "agents-2",
                "agents-3",
                "agents-4",
                "shared-memory-3",
                "shared-memory-5",
                "kanban-2",
                "philosophers-5"
            })
    void quotientIsTheWholeGraphDividedBySymmetry(String name) {
        PetriNet net = ExampleNetNames.find(name).orElseThrow();
        assertThat(NetSymmetry.of(net).isEmpty()).isFalse();

        ReachabilityGraph quotient = quotient(net);

        assertThat(quotient.isComplete()).isTrue();
        assertThat(quotient.states()).isEqualTo(divided(net));
        ReachabilityGraph whole = ReachabilitySearch.explore(net, WHOLE);
        assertThat(quotient.deadlocks().isEmpty()).isEqualTo(whole.deadlocks().isEmpty());
        assertThat(quotient.deadTransitions()).isEqualTo(whole.deadTransitions());
        for (int place = 0; place < net.placeCount(); place++) {
            assertThat(quotient.mostTokens(place)).isEqualTo(whole.mostTokens(place));
        }
        for (int state = 0; state < quotient.states(); state += 7) {
            List<Integer> tokens = IntStream.of(quotient.runTo(state).replay(net))
                    .sorted()
                    .boxed()
                    .toList();
            assertThat(tokens)
                    .isEqualTo(IntStream.of(quotient.marking(state))
                            .sorted()
                            .boxed()
                            .toList());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"agents-4", "shared-memory-5", "kanban-2", "philosophers-5"})
    void exchangesThatAreKnownNeedNoSearch(String name) {
        PetriNet net = ExampleNetNames.find(name).orElseThrow();
        NetSymmetry searched = NetSymmetry.of(net);
        List<int[]> images = IntStream.range(0, searched.generators())
                .mapToObj(generator -> IntStream.range(0, net.placeCount())
                        .map(place -> searched.imagesOfPlace(place).get(generator))
                        .toArray())
                .toList();

        NetSymmetry known = NetSymmetry.of(net, images);

        assertThat(known.generators()).isEqualTo(searched.generators());
        assertThat(ReachabilitySearch.explore(net, WHOLE.withSymmetry(known)).states())
                .isEqualTo(quotient(net).states());
    }

    @Test
    void anExchangeThatChangesTheNetIsLeftOut() {
        PetriNet net = ExampleNets.producerConsumer(1);
        int[] first = IntStream.range(0, net.placeCount()).toArray();
        first[0] = 1;
        first[1] = 0;
        int[] noPermutation = new int[net.placeCount()];

        assertThat(NetSymmetry.of(net, List.of(first, noPermutation)).isEmpty()).isTrue();
    }

    @Test
    void sharedMemoryHasThePublishedNumberOfStatesUpToSymmetry() {
        assertThat(quotient(ExampleNets.sharedMemory(5)).states()).isEqualTo(51);
    }

    /** Six steps outside the gate and five within it: multisets of agents over the six, with all agents, and with one of them in the gate. */
    @Test
    void agentsAreCountedAndNotTold() {
        assertThat(quotient(ExampleNets.agents(6)).states()).isEqualTo(choose(11, 5) + 5 * choose(10, 5));
    }

    private static int choose(int n, int k) {
        long product = 1;
        for (int i = 1; i <= k; i++) {
            product = product * (n - k + i) / i;
        }
        return (int) product;
    }

    @Test
    void netInWhichAllIsDifferentHasNone() {
        PetriNetBuilder net = new PetriNetBuilder("chain");
        net.place("a", 1);
        net.place("b", 0);
        net.place("c", 0);
        net.move("first", List.of("a"), List.of("b"));
        net.move("second", List.of("b"), List.of("c"));

        assertThat(NetSymmetry.of(net.build()).isEmpty()).isTrue();
        assertThat(NetSymmetry.of(ExampleNets.producerConsumer(0)).isEmpty()).isTrue();
    }

    @Test
    void tokensOfTheInitialMarkingTellComponentsApart() {
        PetriNetBuilder net = new PetriNetBuilder("two");
        net.place("a", 1);
        net.place("b", 2);
        net.move("first", List.of("a"), List.of());
        net.move("second", List.of("b"), List.of());

        assertThat(NetSymmetry.of(net.build()).isEmpty()).isTrue();
    }

    @Test
    void quotientsOfRandomNetsSayWhatTheWholeGraphsSay() {
        int smaller = 0;
        for (long seed = 0; seed < 1000; seed++) {
            PetriNet net = CopiedNets.net(seed);
            NetSymmetry symmetry = NetSymmetry.of(net);
            ReachabilityGraph whole = ReachabilitySearch.explore(net, WHOLE);
            ReachabilityGraph quotient = ReachabilitySearch.explore(net, WHOLE.withSymmetry(symmetry));
            ReachabilityGraph both =
                    ReachabilitySearch.explore(net, WHOLE.withSymmetry(symmetry).withReduction());

            assertThat(quotient.deadTransitions()).as("seed %d", seed).isEqualTo(whole.deadTransitions());
            for (int place = 0; place < net.placeCount(); place++) {
                assertThat(quotient.mostTokens(place)).as("seed %d", seed).isEqualTo(whole.mostTokens(place));
            }
            Set<List<Integer>> deadlocks = normalDeadlocks(whole, symmetry);
            assertThat(normalDeadlocks(quotient, symmetry)).as("seed %d", seed).isEqualTo(deadlocks);
            assertThat(normalDeadlocks(both, symmetry)).as("seed %d", seed).isEqualTo(deadlocks);
            for (int deadlock : both.deadlocks()) {
                int[] reached = both.runTo(deadlock).replay(net);
                assertThat(whole.deadlocks())
                        .as("seed %d", seed)
                        .contains(whole.stateOf(reached).orElseThrow());
            }
            smaller += quotient.states() < whole.states() ? 1 : 0;
        }
        assertThat(smaller).isGreaterThan(500);
    }

    private static Set<List<Integer>> normalDeadlocks(ReachabilityGraph graph, NetSymmetry symmetry) {
        Set<List<Integer>> normal = new HashSet<>();
        for (int deadlock : graph.deadlocks()) {
            int[] marking = graph.marking(deadlock);
            symmetry.normalize(marking);
            normal.add(IntStream.of(marking).boxed().toList());
        }
        return normal;
    }

    private static PetriNet chain(int places) {
        PetriNetBuilder net = new PetriNetBuilder("chain");
        for (int place = 0; place < places; place++) {
            net.place("p" + place, 0);
        }
        for (int place = 1; place < places; place++) {
            net.move("t" + place, List.of("p" + (place - 1)), List.of("p" + place));
        }
        return net.build();
    }

    @Test
    void coloursOfALongChainAreRefinedNoFurtherThanTheWorkAllows() {
        PetriNet net = chain(400);
        long round = new PairedColours(net, 1).work();

        assertThat(new PairedColours(net, 10 * round).work()).isEqualTo(10 * round);
        assertThat(new PairedColours(net, Long.MAX_VALUE).work()).isGreaterThan(100 * round);
    }

    @Test
    void searchForPermutationsEndsWithItsWork() {
        PetriNet net = ExampleNets.philosophers(5);

        assertThat(new SymmetrySearch(net, 1).find()).isEmpty();
        assertThat(new SymmetrySearch(net, SymmetrySearch.MOST_WORK).find()).isNotEmpty();
    }
}
