package org.sami.petri.coverability;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.BitSet;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.FiringRule;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.petri.query.LinearComparison;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.query.QueryMeans;
import org.sami.petri.query.QueryRunner;
import org.sami.petri.symmetry.NetSymmetry;

class SaturatedQueriesTest {
    private static final SearchBudget ENOUGH = SearchBudget.ofStates(3_000);
    private static final List<LinearComparison.Relation> RELATIONS =
            List.copyOf(EnumSet.allOf(LinearComparison.Relation.class));

    /** Markings of a net from which firings that are called sure are tried. */
    private static final int MOST_FIRED = 100;

    private static final MarkingCondition NEVER = new MarkingCondition.Any(List.of());

    @Test
    void answersAboutRandomNetsAreThoseOfTheWholeGraph() {
        Counts counts = new Counts();
        for (long seed = 0; seed < 2_500; seed++) {
            assertThat(difference(seed, counts)).isEmpty();
        }
        assertThat(counts.answered.getOrDefault(NetVerdict.YES, 0)).isGreaterThan(200);
        assertThat(counts.answered.getOrDefault(NetVerdict.NO, 0)).isGreaterThan(200);
        assertThat(counts.homes).isGreaterThan(80);
    }

    /** What differs between the saturated and the whole graph of a seed's net; empty where nothing does, or one of them is too large. */
    static Optional<String> difference(long seed, Counts counts) {
        PetriNet net = net(seed);
        Random random = new Random(-seed);
        Optional<SaturatedQueries> saturated = saturated(net, random);
        QueryRunner exact = new QueryRunner(
                net, ENOUGH, new QueryMeans(false, Optional.empty()), GraphWatch.NONE, System::nanoTime);
        if (saturated.isEmpty() || !exact.whole().isComplete()) {
            return Optional.empty();
        }
        for (NetQuery query : queries(net, random)) {
            Optional<QueryAnswer> answer = saturated.get().answer(query);
            if (answer.isPresent()) {
                NetVerdict right = exact.answer(query).verdict();
                if (answer.get().verdict() != right) {
                    return Optional.of("seed " + seed + ": " + query + " is " + right);
                }
                counts.answered.merge(right, 1, Integer::sum);
                counts.homes += query instanceof NetQuery.Home ? 1 : 0;
            }
        }
        return lost(saturated.get(), exact.whole())
                .map(marking -> "seed " + seed + ": no image of the marking " + marking)
                .or(() -> unsure(saturated.get().net(), exact.whole()).map(firing -> "seed " + seed + ": " + firing))
                .or(() -> wrong(saturated.get(), net).map(firing -> "seed " + seed + ": " + firing));
    }

    /** A marking of the whole graph whose image the saturated graph does not have. How many tokens an end leaves in an exact place is not followed. */
    private static Optional<String> lost(SaturatedQueries saturated, ReachabilityGraph whole) {
        Set<String> images = IntStream.range(0, saturated.graph().states())
                .mapToObj(
                        state -> image(saturated, whole.net(), saturated.graph().marking(state)))
                .collect(Collectors.toSet());
        return IntStream.range(0, whole.states())
                .mapToObj(whole::marking)
                .filter(marking -> !images.contains(image(saturated, whole.net(), marking)))
                .map(Arrays::toString)
                .findFirst();
    }

    private static String image(SaturatedQueries saturated, PetriNet net, int[] marking) {
        SaturablePlaces rules = new SaturablePlaces(net);
        int[] image = marking.clone();
        saturated.net().places().stream()
                .forEach(place -> image[place] = rules.isExact(place) ? 0 : Math.min(1, image[place]));
        return Arrays.toString(image);
    }

    /** A firing that is called sure and which a marking with the tokens that it needs, or with more in a saturated place, does not do. */
    private static Optional<String> unsure(SaturatedNet saturated, ReachabilityGraph whole) {
        SaturablePlaces rules = new SaturablePlaces(whole.net());
        for (int state = 0; state < Math.min(MOST_FIRED, whole.states()); state++) {
            int[] marking = whole.marking(state);
            int[] image = marking.clone();
            saturated.places().stream().forEach(place -> image[place] = Math.min(1, image[place]));
            Optional<String> found = IntStream.concat(
                            IntStream.of(-1), saturated.places().stream().filter(place -> !rules.isExact(place)))
                    .mapToObj(place -> IntStream.range(0, image.length)
                            .map(p -> p == place ? 0 : image[p])
                            .toArray())
                    .flatMap(from -> IntStream.range(0, saturated.net().transitionCount())
                            .filter(saturated::isSure)
                            .filter(t -> FiringRule.isEnabled(saturated.net(), t, from))
                            .filter(t -> !follows(saturated, t, from, whole.net(), marking))
                            .mapToObj(t -> saturated.net().transitionId(t) + " is not sure at "
                                    + Arrays.toString(marking) + ", which " + Arrays.toString(from) + " stands for"))
                    .findFirst();
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    private static boolean follows(SaturatedNet saturated, int t, int[] from, PetriNet net, int[] marking) {
        if (!FiringRule.isEnabled(net, saturated.original(t), marking)) {
            return false;
        }
        int[] less = FiringRule.fire(saturated.net(), t, from);
        int[] more = FiringRule.fire(net, saturated.original(t), marking);
        return IntStream.range(0, less.length)
                .allMatch(place ->
                        saturated.places().get(place) ? more[place] >= less[place] : more[place] == less[place]);
    }

    /** A state with more than one token in a saturated place, or a transition that stands for one of another name. */
    private static Optional<String> wrong(SaturatedQueries saturated, PetriNet net) {
        SaturatedNet made = saturated.net();
        for (int t = 0; t < made.net().transitionCount(); t++) {
            if (!made.net().transitionId(t).split("~")[0].equals(net.transitionId(made.original(t)))) {
                return Optional.of(made.net().transitionId(t) + " stands for " + made.original(t));
            }
        }
        return made.places().stream()
                .filter(place -> saturated.graph().mostTokens(place) > 1)
                .mapToObj(place -> "place " + place + " has more than one token")
                .findFirst();
    }

    /** What was compared. */
    static final class Counts {
        final Map<NetVerdict, Integer> answered = new EnumMap<>(NetVerdict.class);
        int homes;
    }

    @Test
    void aBufferWithoutBoundHasFewStates() {
        PetriNet net = OpenNets.producerAndConsumer();
        SaturatedSearch search = new SaturatedSearch(
                WiderNet.exact(net),
                new SaturablePlaces(net).all(),
                ENOUGH,
                NetSymmetry::of,
                GraphWatch.NONE,
                System::nanoTime);

        ReachabilityGraph exact = search.exact();
        SaturatedQueries queries = search.saturated(exact).orElseThrow();

        assertThat(exact.isComplete()).isFalse();
        assertThat(queries.net().places()).isEqualTo(BitSet.valueOf(new long[] {1 << 2}));
        assertThat(queries.graph().states()).isEqualTo(8);
        assertThat(queries.answer(new NetQuery.Deadlock(NEVER)).orElseThrow().verdict())
                .isEqualTo(NetVerdict.NO);
        assertThat(queries.answer(new NetQuery.Home(atLeast(4, 1)))
                        .orElseThrow()
                        .verdict())
                .isEqualTo(NetVerdict.YES);
        assertThat(queries.answer(new NetQuery.Bound(2)))
                .as("how many is not followed")
                .isEmpty();
        assertThat(queries.answer(new NetQuery.Reachable(atLeast(2, 9)))).isEmpty();
        assertThat(queries.answer(new NetQuery.Reachable(atLeast(0, 2)))
                        .orElseThrow()
                        .verdict())
                .isEqualTo(NetVerdict.NO);
    }

    /** What a token that is left promises, who needs two tokens does not find: such a place is not saturated. */
    @Test
    void aPlaceOfWhichTwoTokensAreNeededIsCounted() {
        PetriNetBuilder net = new PetriNetBuilder("pairs");
        net.place("one", 0);
        net.place("two", 0);
        net.transition("make");
        net.produce(0, 0, 1).produce(0, 1, 1);
        net.transition("pair");
        net.consume(1, 1, 2);

        SaturablePlaces places = new SaturablePlaces(net.build());

        assertThat(places.contains(0)).isTrue();
        assertThat(places.contains(1)).isFalse();
    }

    private static MarkingCondition atLeast(int place, int tokens) {
        return new LinearComparison(
                List.of(new LinearComparison.Term(place, 1)), LinearComparison.Relation.AT_LEAST, tokens);
    }

    private static Optional<SaturatedQueries> saturated(PetriNet net, Random random) {
        SaturablePlaces saturable = new SaturablePlaces(net);
        BitSet places = new BitSet();
        for (int place = 0; place < net.placeCount(); place++) {
            places.set(place, saturable.contains(place) && random.nextInt(2) == 0);
        }
        if (places.isEmpty()) {
            return Optional.empty();
        }
        SaturatedNet saturated = SaturatedNet.of(net, places);
        ReachabilityGraph graph = ReachabilitySearch.explore(
                saturated.net(), SearchSettings.within(ENOUGH).withEdgesOf(saturated::isSure));
        return graph.isComplete()
                ? Optional.of(new SaturatedQueries(WiderNet.exact(net), saturated, graph, ENOUGH.bytes()))
                : Optional.empty();
    }

    private static List<NetQuery> queries(PetriNet net, Random random) {
        int place = random.nextInt(net.placeCount());
        MarkingCondition some = new LinearComparison(
                List.of(new LinearComparison.Term(place, 1)),
                RELATIONS.get(random.nextInt(RELATIONS.size())),
                random.nextInt(3));
        return List.of(
                new NetQuery.Deadlock(NEVER),
                new NetQuery.Deadlock(some),
                new NetQuery.Home(some),
                new NetQuery.Home(new MarkingCondition.Not(some)),
                new NetQuery.Reachable(some),
                new NetQuery.Invariant(some));
    }

    /** Small nets of light arcs; in every second one a place is needed by all, and some transitions take it for good. */
    private static PetriNet net(long seed) {
        Random random = new Random(seed);
        PetriNetBuilder net = new PetriNetBuilder("random-" + seed);
        int places = 3 + random.nextInt(4);
        int transitions = 3 + random.nextInt(5);
        for (int p = 0; p < places; p++) {
            net.place("p" + p, random.nextInt(3));
        }
        boolean ends = seed % 2 == 0;
        if (ends) {
            net.place("running", 1);
        }
        for (int t = 0; t < transitions; t++) {
            net.transition("t" + t);
            net.consume(t, random.nextInt(places), 1);
            if (random.nextInt(3) == 0) {
                net.consume(t, random.nextInt(places), 1);
            }
            if (random.nextInt(8) > 0) {
                net.produce(t, random.nextInt(places), 1);
            }
            if (random.nextInt(6) == 0) {
                net.produce(t, random.nextInt(places), 1 + random.nextInt(2));
            }
            if (random.nextInt(4) == 0) {
                net.inhibit(t, random.nextInt(places), seed % 5 == 0 ? 2 : 1);
            }
            if (random.nextInt(6) == 0) {
                net.reset(t, random.nextInt(places));
            }
            if (ends) {
                net.consume(t, places, 1);
                if (random.nextInt(3) > 0) {
                    net.produce(t, places, 1);
                }
            }
        }
        return net.build();
    }

    @Test
    void wayHomeThatNeedsMoreMemoryThanTheBudgetIsLeftOpen() {
        PetriNetBuilder builder = new PetriNetBuilder("ring");
        builder.place("p", 1);
        builder.place("q", 0);
        builder.move("go", List.of("p"), List.of("q"));
        builder.move("back", List.of("q"), List.of("p"));
        PetriNet net = builder.build();
        SaturatedNet saturated = SaturatedNet.of(net, new BitSet());
        ReachabilityGraph graph = ReachabilitySearch.explore(
                saturated.net(), SearchSettings.within(ENOUGH).withEdges());
        NetQuery home = new NetQuery.Home(atLeast(0, 1));

        assertThat(new SaturatedQueries(WiderNet.exact(net), saturated, graph, ENOUGH.bytes()).answer(home))
                .isPresent();
        assertThat(new SaturatedQueries(WiderNet.exact(net), saturated, graph, graph.bytes()).answer(home))
                .isEmpty();
    }
}
