package org.sami.petri.coverability;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
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
    private static final MarkingCondition NEVER = new MarkingCondition.Any(List.of());

    @Test
    void answersAboutRandomNetsAreThoseOfTheWholeGraph() {
        Map<NetVerdict, Integer> answered = new EnumMap<>(NetVerdict.class);
        int homes = 0;
        for (long seed = 0; seed < 2_500; seed++) {
            PetriNet net = net(seed);
            Random random = new Random(-seed);
            Optional<SaturatedQueries> saturated = saturated(net, random);
            QueryRunner exact = new QueryRunner(
                    net, ENOUGH, new QueryMeans(false, Optional.empty()), GraphWatch.NONE, System::nanoTime);
            if (saturated.isEmpty() || !exact.whole().isComplete()) {
                continue;
            }
            for (NetQuery query : queries(net, random)) {
                Optional<QueryAnswer> answer = saturated.get().answer(query);
                if (answer.isPresent()) {
                    assertThat(answer.get().verdict())
                            .as("seed %d: %s", seed, query)
                            .isEqualTo(exact.answer(query).verdict());
                    answered.merge(answer.get().verdict(), 1, Integer::sum);
                    homes += query instanceof NetQuery.Home ? 1 : 0;
                }
            }
            for (int place = 0; place < net.placeCount(); place++) {
                if (!saturated.get().net().places().get(place)) {
                    assertThat(saturated.get().graph().mostTokens(place))
                            .as("seed %d, place %d", seed, place)
                            .isGreaterThanOrEqualTo(exact.whole().mostTokens(place));
                }
            }
        }
        assertThat(answered.getOrDefault(NetVerdict.YES, 0)).isGreaterThan(200);
        assertThat(answered.getOrDefault(NetVerdict.NO, 0)).isGreaterThan(200);
        assertThat(homes).isGreaterThan(80);
    }

    @Test
    void aBufferWithoutBoundHasFewStates() {
        PetriNet net = OpenNets.producerAndConsumer();
        SaturatedSearch search = new SaturatedSearch(
                net, new SaturablePlaces(net).all(), ENOUGH, NetSymmetry::of, GraphWatch.NONE, System::nanoTime);

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
        return graph.isComplete() ? Optional.of(new SaturatedQueries(saturated, graph)) : Optional.empty();
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
                net.inhibit(t, random.nextInt(places), 1);
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
}
