package org.sami.petri.coverability;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchEnd;
import org.sami.petri.model.ExampleNets;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.petri.structure.NaiveMarkings;
import org.sami.petri.structure.SeededNets;
import org.sami.petri.structure.StructuralAnswers;
import org.sami.petri.structure.StructureLimits;

final class CoverabilitySearchTest {
    private static final SearchBudget ENOUGH = SearchBudget.ofStates(100_000);

    @Test
    void aProducerAndAConsumerHaveFourMarkings() {
        CoverabilitySet set = search(OpenNets.producerAndConsumer());

        assertThat(set.isComplete()).isTrue();
        assertThat(set.size()).isEqualTo(4);
        assertThat(set.isUnbounded(2)).isTrue();
        assertThat(set.mostTokens(0)).hasValue(1);
        assertThat(set.mostTokens(2)).isEmpty();
        assertThat(covers(set, new int[] {1, 0, 1_000_000, 0, 1})).isTrue();
        assertThat(covers(set, new int[] {1, 1, 0, 0, 0})).isFalse();
        CoverabilityGraph graph = set.graph();
        assertThat(graph.nodes()).isEqualTo(4);
        assertThat(graph.edges())
                .hasSize(8); // in each of four markings one side of two can move, whatever the other does
    }

    @Test
    void anOpenKanbanHasAsManyMarkingsAsTheClosedOneHasStates() {
        assertThat(search(OpenNets.kanban(1)).size()).isEqualTo(160);
        assertThat(search(ExampleNets.openKanban(1)).size()).isEqualTo(160);
        CoverabilitySet set = search(OpenNets.kanban(2));

        assertThat(set.isComplete()).isTrue();
        assertThat(set.size()).isEqualTo(4_600);
        assertThat(set.isUnbounded(16)).isTrue();
        for (int place = 0; place < 16; place++) {
            assertThat(set.mostTokens(place)).hasValue(2);
        }
    }

    @Test
    void theSetIsThatOfKarpAndMiller() {
        int compared = 0;
        int unbounded = 0;
        for (long seed = 0; seed < 4_000; seed++) {
            PetriNet net = SeededNets.plain(seed, 5, 3);
            Optional<Set<List<Integer>>> expected = PlainKarpMiller.set(net, 2_000);
            if (expected.isPresent()) {
                CoverabilitySet set = search(net);
                assertThat(set.isComplete()).isTrue();
                assertThat(markings(set)).as("seed %d", seed).isEqualTo(expected.get());
                compared++;
                unbounded += expected.get().stream().anyMatch(marking -> marking.contains(Omega.OMEGA)) ? 1 : 0;
            }
        }
        assertThat(compared).isGreaterThan(3_000);
        assertThat(unbounded).isGreaterThan(1_000);
    }

    @Test
    void theGraphHasEachFiringOnce() {
        for (long seed = 0; seed < 500; seed++) {
            PetriNet net = SeededNets.plain(seed, 5, 3);
            CoverabilitySet set = search(net);
            CoverabilityGraph graph = set.graph();
            long enabled = 0;
            for (int node = 0; node < set.size(); node++) {
                for (int transition = 0; transition < net.transitionCount(); transition++) {
                    enabled += Omega.isEnabled(net, transition, set.marking(node)) ? 1 : 0;
                }
            }
            assertThat(graph.edges()).hasSize((int) enabled);
            for (CoverabilityGraph.Edge edge : graph.edges()) {
                int[] after = Omega.fire(net, edge.transition(), set.marking(edge.from()));
                assertThat(new MarkingOrder(net).covers(set.marking(edge.to()), after))
                        .isTrue();
            }
        }
    }

    @Test
    void inhibitorsAndResetsAreExactWhereTheirPlacesAreBounded() {
        int complete = 0;
        int open = 0;
        for (long seed = 0; seed < 3_000; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 4, 2);
            NaiveMarkings markings = new NaiveMarkings(net, 300);
            CoverabilitySet set =
                    CoverabilitySearch.search(net, SearchBudget.ofStates(300), GraphWatch.NONE, System::nanoTime);
            if (set.isComplete()) {
                complete++;
                open += set.isUnbounded(0) || set.isUnbounded(1) ? 1 : 0;
                assertThat(markings.found())
                        .as("seed %d", seed)
                        .allMatch(marking -> covers(
                                set,
                                marking.stream().mapToInt(Integer::intValue).toArray()));
            }
            if (markings.isComplete()) {
                assertThat(set.isComplete()).as("seed %d", seed).isTrue();
                assertThat(markings(set)).as("seed %d", seed).isEqualTo(largest(net, markings.found()));
            }
        }
        assertThat(complete).isGreaterThan(1_000);
        assertThat(open).isGreaterThan(100);
    }

    /** Of each marking with "any number" there must be reachable ones that come near it, with the same numbers elsewhere. */
    @Test
    void whatTheSetHoldsIsReached() {
        int looked = 0;
        for (long seed = 0; seed < 700; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 3, 2);
            CoverabilitySet set =
                    CoverabilitySearch.search(net, SearchBudget.ofStates(40), GraphWatch.NONE, System::nanoTime);
            NaiveMarkings markings = new NaiveMarkings(net, 4_000);
            for (int number = 0; number < set.size() && set.size() < 20; number++) {
                int[] limit = set.marking(number);
                assertThat(markings.found())
                        .as("%s of seed %d", Arrays.toString(limit), seed)
                        .anyMatch(marking -> isNear(limit, marking));
                looked++;
            }
        }
        assertThat(looked).isGreaterThan(700);
    }

    @Test
    void anUnboundedPlaceHasARunThatPumpsIt() {
        PetriNet net = OpenNets.producerAndConsumer();
        CoverabilitySet.Pump pump = search(net).pump(2).orElseThrow();
        assertThat(pump.lead()).isEmpty();
        assertThat(pump.repeated()).containsExactly(0, 1);
        assertThat(search(net).pump(0)).isEmpty();

        int pumped = 0;
        for (long seed = 0; seed < 1_000; seed++) {
            PetriNet random = SeededNets.plain(seed, 5, 2);
            CoverabilitySet set = search(random);
            for (int place = 0; place < random.placeCount(); place++) {
                Optional<CoverabilitySet.Pump> found = set.pump(place);
                assertThat(found.isEmpty() || set.isUnbounded(place)).isTrue();
                if (found.isPresent()) {
                    pumped++;
                    assertThat(afterRounds(random, found.get(), place, 5)).isGreaterThanOrEqualTo(5);
                }
            }
        }
        assertThat(pumped).isGreaterThan(500);
    }

    @Test
    void whereAnInhibitedPlaceGrowsTheAnswerSaysHowFarItLooked() {
        PetriNetBuilder builder = new PetriNetBuilder("counter");
        builder.place("counted", 0);
        builder.place("zero", 0);
        builder.move("count", List.of(), List.of("counted"));
        int test = builder.move("isZero", List.of(), List.of("zero"));
        builder.inhibit(test, 0, 1);
        PetriNet net = builder.build();

        CoverabilityAnswers answers = answers(net, 50);

        assertThat(answers.unproved()).containsExactly(0);
        assertThat(answers.set().end()).isEqualTo(SearchEnd.STATES);
        assertThat(answers.words(net))
                .isEqualTo("undecidable here, as inhibitor or reset arcs go to places without a proved bound (counted):"
                        + " searched to 51 markings (the budget of states was used up)");
        assertThat(answers.unbounded(net)).containsExactly(1); // it is, with the number of the other one
        assertThat(answers(OpenNets.kanban(1), 20).words(OpenNets.kanban(1)))
                .startsWith("bounded search only: searched to ");
        assertThat(answers(OpenNets.producerAndConsumer(), 20).words(OpenNets.producerAndConsumer()))
                .isEqualTo("minimal coverability set of 4 markings");
    }

    @Test
    void aSearchKeepsToItsBudget() {
        PetriNet net = OpenNets.kanban(2);
        AtomicLong clock = new AtomicLong(Long.MAX_VALUE - 5);
        AtomicInteger seen = new AtomicInteger();

        assertThat(search(net, new SearchBudget(100, 1 << 30, Duration.ofDays(1)), GraphWatch.NONE, clock))
                .returns(SearchEnd.STATES, CoverabilitySet::end)
                .returns(false, CoverabilitySet::isComplete);
        assertThat(search(net, new SearchBudget(100_000, 50_000, Duration.ofDays(1)), GraphWatch.NONE, clock)
                        .end())
                .isEqualTo(SearchEnd.MEMORY);
        assertThat(search(net, new SearchBudget(100_000, 1 << 30, Duration.ofNanos(3)), GraphWatch.NONE, clock)
                        .end())
                .isEqualTo(SearchEnd.TIME);
        CoverabilitySet stopped =
                search(net, new SearchBudget(100_000, 1 << 30, Duration.ofDays(1)), watch(seen), clock);
        assertThat(stopped.end()).isEqualTo(SearchEnd.CANCELLED);
        assertThat(seen.get()).isPositive();
        // what it shows is so all the same
        assertThat(stopped.isUnbounded(16)).isTrue();
    }

    @Test
    void moreTokensThanCanBeCountedEndTheSearch() {
        PetriNetBuilder builder = new PetriNetBuilder("large");
        builder.place("few", 1);
        builder.place("many", Integer.MAX_VALUE - 2);
        int move = builder.transition("move");
        builder.consume(move, 0, 1).produce(move, 1, 5);

        assertThat(search(builder.build()).end()).isEqualTo(SearchEnd.TOKENS);
    }

    private static boolean covers(CoverabilitySet set, int[] tokens) {
        for (int number = 0; number < set.size(); number++) {
            int[] marking = set.marking(number);
            boolean covers = true;
            for (int place = 0; place < tokens.length; place++) {
                covers &= marking[place] >= tokens[place];
            }
            if (covers) {
                return true;
            }
        }
        return false;
    }

    private static CoverabilitySet search(PetriNet net) {
        return CoverabilitySearch.search(net, ENOUGH, GraphWatch.NONE, System::nanoTime);
    }

    private static CoverabilitySet search(PetriNet net, SearchBudget budget, GraphWatch watch, AtomicLong clock) {
        return CoverabilitySearch.search(net, budget, watch, clock::incrementAndGet);
    }

    private static CoverabilityAnswers answers(PetriNet net, int states) {
        return CoverabilityAnswers.of(
                net,
                new StructuralAnswers(net, StructureLimits.USUAL),
                SearchBudget.ofStates(states),
                GraphWatch.NONE,
                System::nanoTime);
    }

    private static GraphWatch watch(AtomicInteger seen) {
        return new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {
                seen.addAndGet(states);
            }

            @Override
            public boolean isCancelled() {
                return seen.get() > 0;
            }
        };
    }

    private static int afterRounds(PetriNet net, CoverabilitySet.Pump pump, int place, int rounds) {
        List<Integer> run = new ArrayList<>(pump.lead());
        for (int i = 0; i < rounds; i++) {
            run.addAll(pump.repeated());
        }
        List<Integer> marking = new ArrayList<>();
        Arrays.stream(net.initialMarking()).forEach(marking::add);
        for (int transition : run) {
            assertThat(NaiveMarkings.enabled(net, marking, transition)).isTrue();
            marking = NaiveMarkings.fired(net, marking, transition);
        }
        return marking.get(place);
    }

    private static boolean isNear(int[] limit, List<Integer> marking) {
        for (int place = 0; place < limit.length; place++) {
            boolean fits = limit[place] == Omega.OMEGA ? marking.get(place) >= 2 : marking.get(place) == limit[place];
            if (!fits) {
                return false;
            }
        }
        return true;
    }

    private static Set<List<Integer>> markings(CoverabilitySet set) {
        Set<List<Integer>> markings = new HashSet<>();
        for (int number = 0; number < set.size(); number++) {
            markings.add(Arrays.stream(set.marking(number)).boxed().toList());
        }
        return markings;
    }

    /** Those that no other covers with the same numbers in places with inhibitor or reset arcs. */
    private static Set<List<Integer>> largest(PetriNet net, Set<List<Integer>> markings) {
        Set<List<Integer>> largest = new HashSet<>();
        for (List<Integer> marking : markings) {
            if (markings.stream().noneMatch(other -> !other.equals(marking) && covers(net, other, marking))) {
                largest.add(marking);
            }
        }
        return largest;
    }

    private static boolean covers(PetriNet net, List<Integer> large, List<Integer> small) {
        for (int place = 0; place < small.size(); place++) {
            boolean exact = false;
            for (int transition = 0; transition < net.transitionCount(); transition++) {
                exact |= net.inhibitors().weight(transition, place) > 0
                        || net.resets().weight(transition, place) > 0;
            }
            if (large.get(place) < small.get(place)
                    || (exact && !large.get(place).equals(small.get(place)))) {
                return false;
            }
        }
        return true;
    }

    @Test
    void theMostTokensThatANetCanHaveAreNotTakenForAnyNumber() {
        PetriNetBuilder builder = new PetriNetBuilder("full");
        builder.place("p", Integer.MAX_VALUE);
        builder.place("q", 0);
        builder.move("t", List.of("p"), List.of("q"));

        CoverabilitySet set = search(builder.build());

        assertThat(set.end()).isEqualTo(SearchEnd.TOKENS);
        assertThat(set.isUnbounded(0)).isFalse();
        assertThat(set.isUnbounded(1)).isFalse();
    }

    @Test
    void aRunWithMoreTokensThanCanBeCountedIsNotShown() {
        PetriNetBuilder builder = new PetriNetBuilder("heavy");
        int q = builder.place("q", 0);
        int r = builder.place("r", 0);
        builder.produce(builder.transition("a"), q, 1_000_000_000);
        int b = builder.transition("b");
        builder.consume(b, q, 1).produce(b, q, 2_000_000_000).produce(b, r, 1);

        CoverabilitySet set = search(builder.build());

        assertThat(set.isComplete()).isTrue();
        assertThat(set.isUnbounded(r)).isTrue();
        assertThat(set.pump(r)).isEmpty();
        assertThat(set.pump(q)).isPresent();
    }
}
