package org.sami.petri.graph;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.petri.model.ExampleNetNames;
import org.sami.petri.model.ExampleNets;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

class ReachabilitySearchTest {
    private static final int NETS = 3000;
    private static final int MOST = 250;
    private static final SearchSettings WHOLE = SearchSettings.within(SearchBudget.ofStates(2_000_000));

    @Test
    void graphsOfRandomNetsAreThoseOfAPlainExplorer() {
        int complete = 0;
        for (long seed = 0; seed < NETS; seed++) {
            PetriNet net = RandomNets.net(seed);
            PlainExplorer plain = new PlainExplorer(net, MOST);
            ReachabilityGraph graph = ReachabilitySearch.explore(
                    net, SearchSettings.within(SearchBudget.ofStates(MOST)).withEdges());
            if (!plain.isComplete()) {
                assertThat(graph.isComplete()).as("seed %d", seed).isFalse();
                continue;
            }
            complete++;
            assertThat(graph.isComplete()).as("seed %d", seed).isTrue();
            compare(seed, graph, plain);
        }
        assertThat(complete).as("nets whose graphs were compared").isGreaterThan(NETS / 3);
    }

    private static void compare(long seed, ReachabilityGraph graph, PlainExplorer plain) {
        assertThat(graph.states()).as("seed %d", seed).isEqualTo(plain.distances.size());
        assertThat(graph.edges()).as("seed %d", seed).isEqualTo(plain.edges());
        assertThat(graph.deadlocks()).as("seed %d", seed).hasSize((int) plain.deadlocks());
        for (int place = 0; place < graph.net().placeCount(); place++) {
            assertThat(graph.mostTokens(place)).as("seed %d", seed).isEqualTo(plain.most[place]);
        }
        for (int t : graph.deadTransitions()) {
            assertThat(plain.fired[t]).as("seed %d", seed).isFalse();
        }
        for (int state = 0; state < graph.states(); state++) {
            List<Integer> marking = PlainExplorer.list(graph.marking(state));
            List<List<Integer>> next = new ArrayList<>();
            for (int successor : graph.successors(state)) {
                next.add(PlainExplorer.list(graph.marking(successor)));
            }
            assertThat(next).as("seed %d", seed).containsExactlyInAnyOrderElementsOf(plain.successors.get(marking));
            FiringSequence run = graph.runTo(state);
            assertThat(run.transitions()).as("seed %d", seed).hasSize(plain.distances.get(marking));
            assertThat(run.replay(graph.net())).as("seed %d", seed).containsExactly(graph.marking(state));
        }
    }

    @Test
    void reducedSearchesFindADeadlockWhereThereIsOne() {
        int withDeadlock = 0;
        int without = 0;
        for (long seed = 0; seed < 2 * NETS; seed++) {
            PetriNet net = seed % 2 == 0 ? RandomNets.net(seed) : RandomNets.loose(seed);
            PlainExplorer plain = new PlainExplorer(net, MOST);
            if (!plain.isComplete()) {
                continue;
            }
            ReachabilityGraph graph = ReachabilitySearch.explore(net, WHOLE.withReduction());

            assertThat(graph.isComplete()).isTrue();
            assertThat(graph.deadlocks()).as("seed %d", seed).hasSize((int) plain.deadlocks());
            assertThat(graph.states()).isLessThanOrEqualTo(plain.distances.size());
            if (plain.deadlocks() > 0) {
                withDeadlock++;
            } else {
                without++;
            }
        }
        assertThat(withDeadlock).isGreaterThan(300);
        assertThat(without).isGreaterThan(100);
    }

    @Test
    void reducedSearchesTryBothOrdersOfProducingAndResetting() {
        PetriNetBuilder builder = new PetriNetBuilder("orders");
        List.of("a", "b").forEach(place -> builder.place(place, 1));
        int full = builder.place("full", 0);
        builder.move("produce", List.of("a"), List.of("full"));
        int empty = builder.move("empty", List.of("b"), List.of());
        builder.reset(empty, full);

        ReachabilityGraph graph = ReachabilitySearch.explore(builder.build(), WHOLE.withReduction());

        assertThat(graph.deadlocks()).hasSize(2);
    }

    @ParameterizedTest
    @CsvSource({
        "kanban-1, 160, 616",
        "kanban-2, 4600, 28120",
        "kanban-3, 58400, 446400",
        "kanban-4, 454475, 3979850",
        "philosophers-5, 243, 0",
        "philosophers-10, 59049, 0",
        "token-ring-8, 3072, 0",
        "shared-memory-5, 1863, 0",
        "producer-consumer-3, 16, 0",
        "erk-1, 13, 0",
        "erk-10, 47047, 0",
        "circadian-clock-1, 128, 0",
        "circadian-clock-10, 644204, 0",
        "peterson-2, 20754, 0",
        "lamport-2, 380, 0",
        "lamport-3, 19742, 0"
    })
    void numbersOfStatesAreThePublishedOnes(String name, int states, long edges) {
        ReachabilityGraph graph =
                ReachabilitySearch.explore(ExampleNetNames.find(name).orElseThrow(), WHOLE);

        assertThat(graph.isComplete()).isTrue();
        assertThat(graph.states()).isEqualTo(states);
        if (edges > 0) {
            assertThat(graph.edges()).isEqualTo(edges);
        }
    }

    @Test
    void philosophersBlockEachOtherInTwoWays() {
        ReachabilityGraph graph = ReachabilitySearch.explore(ExampleNets.philosophers(8), WHOLE);

        assertThat(graph.deadlocks()).hasSize(2);
        assertThat(graph.runTo(graph.deadlocks().get(0)).transitions()).hasSize(8);
        assertThat(graph.deadTransitions()).isEmpty();
    }

    @Test
    void reducedSearchLooksAtFewStatesOfAgentsThatHardlyMeet() {
        ReachabilityGraph whole = ReachabilitySearch.explore(ExampleNets.agents(4), WHOLE);
        ReachabilityGraph reduced = ReachabilitySearch.explore(ExampleNets.agents(4), WHOLE.withReduction());

        assertThat(whole.states()).isEqualTo(6 * 6 * 6 * 6 + 4 * 5 * 6 * 6 * 6);
        assertThat(reduced.deadlocks()).hasSize(1);
        assertThat(reduced.marking(reduced.deadlocks().get(0)))
                .containsExactly(whole.marking(whole.deadlocks().get(0)));
        assertThat(reduced.states()).isLessThan(whole.states() / 10);
    }

    @Test
    void endsAtTheFirstMarkingThatIsSearchedFor() {
        PetriNet net = ExampleNets.kanban(3);
        int out = net.place("out4").orElseThrow();

        ReachabilityGraph graph = ReachabilitySearch.explore(net, WHOLE.withGoal(marking -> marking[out] == 2));

        assertThat(graph.end()).isEqualTo(SearchEnd.FOUND);
        FiringSequence run = graph.runTo(graph.found().orElseThrow());
        assertThat(run.replay(net)[out]).isEqualTo(2);
        assertThat(run.transitions()).hasSize(14);
    }

    @Test
    void netThatGrowsForEverEndsWithItsBudget() {
        PetriNet net = ExampleNets.producerConsumer(0);
        int buffer = net.place("buffer").orElseThrow();

        ReachabilityGraph graph = ReachabilitySearch.explore(net, SearchSettings.within(SearchBudget.ofStates(10_000)));

        assertThat(graph.end()).isEqualTo(SearchEnd.STATES);
        assertThat(graph.states()).isEqualTo(10_000);
        assertThat(graph.mostTokens(buffer)).isGreaterThan(1000);
        assertThat(graph.marking(9_999)[buffer]).isPositive();
    }

    @ParameterizedTest
    @CsvSource({
        "kanban, 2_000_000, false",
        "kanban, 3_000_000, true",
        "kanban, 5_300_000, false",
        "kanban, 7_900_000, true",
        "philosophers, 3_000_000, false",
        "philosophers, 4_700_000, true",
        "philosophers, 6_100_000, false",
        "producer-consumer, 2_000_000, false",
        "producer-consumer, 3_700_000, true"
    })
    void memoryIsUsedAndNoMoreThanTheBudget(String family, String budget, boolean hasEdges) {
        long bytes = Long.parseLong(budget.replace("_", ""));
        PetriNet net = switch (family) {
            case "kanban" -> ExampleNets.kanban(4);
            case "philosophers" -> ExampleNets.philosophers(14);
            default -> ExampleNets.producerConsumer(0); // its states are packed again and again
        };
        SearchSettings settings =
                SearchSettings.within(new SearchBudget(SearchBudget.MOST_STATES, bytes, Duration.ofDays(1)));

        ReachabilityGraph graph = ReachabilitySearch.explore(net, hasEdges ? settings.withEdges() : settings);

        assertThat(graph.end()).isEqualTo(SearchEnd.MEMORY);
        assertThat(graph.bytes()).isBetween(bytes * 4 / 5, bytes + bytes / 1000);
    }

    @Test
    void budgetOfTimeIsThatOfTheClockThatIsGiven() {
        long[] now = {0};

        ReachabilityGraph graph = ReachabilitySearch.explore(
                ExampleNets.kanban(4),
                SearchSettings.within(new SearchBudget(SearchBudget.MOST_STATES, 1L << 30, Duration.ofSeconds(3))),
                GraphWatch.NONE,
                () -> now[0] += 1_000_000_000);

        assertThat(graph.end()).isEqualTo(SearchEnd.TIME);
        assertThat(graph.states()).isBetween(2048, 60_000);
    }

    @Test
    void statesThatWaitAreLookedAtForATenthOfTheTimeMore() {
        int ends = 3_000;
        PetriNetBuilder net = new PetriNetBuilder("fork");
        net.place("start", 1);
        for (int i = 0; i < ends; i++) {
            net.place("end" + i, 0);
            net.transition("go" + i);
            net.consume(i, 0, 1).produce(i, i + 1, 1);
        }
        long[] now = {0};

        ReachabilityGraph graph = ReachabilitySearch.explore(
                net.build(),
                SearchSettings.within(new SearchBudget(SearchBudget.MOST_STATES, 1L << 30, Duration.ofSeconds(2))),
                GraphWatch.NONE,
                () -> now[0] += 1_000_000_000);

        assertThat(graph.end()).isEqualTo(SearchEnd.TIME);
        assertThat(graph.states()).isEqualTo(ends + 1);
        assertThat(graph.deadlocks()).hasSizeBetween(1, ends / 2);
    }

    @Test
    void searchIsStoppedFromOutside() {
        List<Integer> seen = new ArrayList<>();
        GraphWatch watch = new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {
                seen.add(states);
            }

            @Override
            public boolean isCancelled() {
                return seen.size() == 3;
            }
        };

        ReachabilityGraph graph = ReachabilitySearch.explore(ExampleNets.kanban(4), WHOLE, watch, System::nanoTime);

        assertThat(graph.end()).isEqualTo(SearchEnd.CANCELLED);
        assertThat(seen).hasSize(3).isSorted();
    }

    @Test
    void placeThatHasTooManyTokensEndsTheSearch() {
        PetriNetBuilder builder = new PetriNetBuilder("doubling");
        int place = builder.place("p", 3);
        int t = builder.transition("t");
        builder.produce(t, place, 1 << 30);

        ReachabilityGraph graph = ReachabilitySearch.explore(builder.build(), WHOLE);

        assertThat(graph.end()).isEqualTo(SearchEnd.TOKENS);
        assertThat(graph.states()).isEqualTo(2);
        assertThat(graph.mostTokens(place)).isEqualTo((1 << 30) + 3);
    }

    @Test
    void netsWithoutPlacesOrTransitionsHaveOneState() {
        PetriNetBuilder withoutPlaces = new PetriNetBuilder("t");
        withoutPlaces.transition("t");
        PetriNetBuilder withoutTransitions = new PetriNetBuilder("p");
        withoutTransitions.place("p", 2);

        ReachabilityGraph first = ReachabilitySearch.explore(withoutPlaces.build(), WHOLE);
        ReachabilityGraph second = ReachabilitySearch.explore(withoutTransitions.build(), WHOLE);

        assertThat(first.states()).isEqualTo(1);
        assertThat(first.edges()).isEqualTo(1);
        assertThat(first.deadlocks()).isEmpty();
        assertThat(second.deadlocks()).containsExactly(0);
    }

    @Test
    void manyPlacesThatAllGrowArePackedAgainAFewTimesOnly() {
        PetriNetBuilder builder = new PetriNetBuilder("wide");
        int[] places = new int[300];
        Arrays.setAll(places, p -> builder.place("p" + p, 0));
        int t = builder.transition("t");
        for (int place : places) {
            builder.produce(t, place, 1 + place % 7);
        }

        ReachabilityGraph graph =
                ReachabilitySearch.explore(builder.build(), SearchSettings.within(SearchBudget.ofStates(2000)));

        assertThat(graph.states()).isEqualTo(2000);
        int[] last = graph.marking(1999);
        for (int place : places) {
            assertThat(last[place]).isEqualTo(1999 * (1 + place % 7));
        }
    }

    @Test
    void aRunIsGivenWhereAnotherFiringWouldLeadToMoreTokensThanCanBeCounted() {
        PetriNetBuilder builder = new PetriNetBuilder("full");
        int full = builder.place("full", Integer.MAX_VALUE);
        int first = builder.place("first", 1);
        int second = builder.place("second", 1);
        int goal = builder.place("goal", 0);
        int overflows = builder.transition("overflows");
        builder.consume(overflows, second, 1).produce(overflows, full, 1);
        builder.move("reaches", List.of("first"), List.of("goal"));

        ReachabilityGraph graph = ReachabilitySearch.explore(builder.build(), WHOLE.withGoal(m -> m[goal] == 1));

        assertThat(first).isLessThan(second);
        assertThat(graph.runTo(graph.found().orElseThrow()).transitions()).containsExactly(1);
    }

    @Test
    void statesWithManyFiringsAreFewBeforeTheWatchIsAsked() {
        PetriNetBuilder builder = new PetriNetBuilder("wide");
        int place = builder.place("p", 0);
        for (int tokens = 1; tokens <= 5_000; tokens++) {
            builder.produce(builder.transition("t" + tokens), place, tokens);
        }
        AtomicInteger asked = new AtomicInteger();
        GraphWatch watch = new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {}

            @Override
            public boolean isCancelled() {
                return asked.incrementAndGet() > 1;
            }
        };

        ReachabilityGraph graph = ReachabilitySearch.explore(builder.build(), WHOLE, watch, () -> 0);

        assertThat(graph.end()).isEqualTo(SearchEnd.CANCELLED);
        assertThat(graph.looked()).isEqualTo(4);
    }

    /** Two tokens that move on by themselves, in places of which each has one bit of one word; with the end, two more tokens at last. */
    private static PetriNet twoChains(boolean hasEnd) {
        PetriNetBuilder builder = new PetriNetBuilder("chains");
        for (int place = 0; place < 31; place++) {
            builder.place("a" + place, place == 0 ? 1 : 0);
            builder.place("b" + place, place == 0 ? 1 : 0);
        }
        builder.place("more", 0);
        builder.place("none", 0);
        for (int place = 1; place < 31; place++) {
            builder.move("a" + place, List.of("a" + (place - 1)), List.of("a" + place));
            builder.move("b" + place, List.of("b" + (place - 1)), List.of("b" + place));
        }
        if (hasEnd) {
            builder.produce(builder.move("end", List.of("a30", "b30"), List.of()), builder.placeNumber("more"), 2);
        }
        return builder.build();
    }

    @Test
    void keptEdgesCountWhereStatesArePackedAgain() {
        long before =
                ReachabilitySearch.explore(twoChains(false), WHOLE.withEdges()).bytes();
        SearchBudget little = new SearchBudget(2_000_000, before + 2_000, Duration.ofDays(1));

        ReachabilityGraph graph = ReachabilitySearch.explore(
                twoChains(true), SearchSettings.within(little).withEdges());

        assertThat(graph.states()).isEqualTo(31 * 31);
        assertThat(graph.end()).isEqualTo(SearchEnd.MEMORY);
        assertThat(graph.bytes()).isLessThanOrEqualTo(little.bytes());
    }

    @Test
    void firingsOfAStateAreItsEdges() {
        PetriNet net = ExampleNets.philosophers(3);
        ReachabilityGraph graph = ReachabilitySearch.explore(
                net, SearchSettings.within(SearchBudget.ofStates(1_000)).withEdges());

        for (int state = 0; state < graph.states(); state++) {
            assertThat(graph.firings(state).stream()
                            .mapToInt(ReachabilityGraph.StateFiring::target)
                            .toArray())
                    .isEqualTo(graph.successors(state));
        }
    }

    /** A net whose first states have 5,000 firings each, so that few are looked at and many wait. */
    private static PetriNet manyWaiting() {
        PetriNetBuilder builder = new PetriNetBuilder("wide");
        int place = builder.place("p", 0);
        for (int tokens = 1; tokens <= 5_000; tokens++) {
            builder.produce(builder.transition("t" + tokens), place, tokens);
        }
        return builder.build();
    }

    /** Stops a search when it is asked for the second time. */
    private static GraphWatch stopsAtTheSecondLook() {
        AtomicInteger asked = new AtomicInteger();
        return new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {}

            @Override
            public boolean isCancelled() {
                return asked.incrementAndGet() > 1;
            }
        };
    }

    @Test
    void waitingStatesAreNotLookedAtOnceTheSearchIsStopped() {
        AtomicInteger tested = new AtomicInteger();

        ReachabilityGraph graph = ReachabilitySearch.explore(
                manyWaiting(),
                WHOLE.withGoal(marking -> tested.incrementAndGet() < 0),
                stopsAtTheSecondLook(),
                () -> 0);

        assertThat(graph.end()).isEqualTo(SearchEnd.CANCELLED);
        assertThat(graph.states()).isGreaterThan(5_000);
        assertThat(tested.get()).isEqualTo(graph.looked());
    }

    @Test
    void lookAtWaitingStatesEndsWhenTheSearchIsStopped() {
        AtomicInteger tested = new AtomicInteger();

        ReachabilityGraph graph = ReachabilitySearch.explore(
                manyWaiting(),
                SearchSettings.within(SearchBudget.ofStates(5_003)).withGoal(marking -> tested.incrementAndGet() < 0),
                stopsAtTheSecondLook(),
                () -> 0);

        assertThat(graph.end()).isEqualTo(SearchEnd.STATES);
        assertThat(tested.get()).isLessThan(200);
    }
}
