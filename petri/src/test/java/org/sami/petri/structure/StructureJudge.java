package org.sami.petri.structure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.LongConsumer;
import java.util.stream.IntStream;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.query.RandomConditions;
import org.sami.petri.structure.LinearCondition.AtLeast;

/** Compares what structure proves of a seed's random net with its markings: bounds, what never holds, that it never stops; and which numbers count as a proof. */
public final class StructureJudge implements LongConsumer {
    private static final StructureLimits FEW_PROGRAMS = new StructureLimits(5_000, 1_000, 12, () -> false);
    private static final int QUERIES = 3;
    private static final int TRIES = 20;

    /** Nothing is judged yet. */
    public StructureJudge() {}

    @Override
    public void accept(long seed) {
        int mostWeight = 1 + (int) (seed % 2);
        PetriNet net = seed % 3 == 0
                ? SeededNets.withResets(seed, 5, mostWeight)
                : SeededNets.withAllArcs(seed, 5, mostWeight);
        NaiveMarkings markings = new NaiveMarkings(net, 300);
        Random random = new Random(seed);
        StructuralAnswers answers = new StructuralAnswers(net, FEW_PROGRAMS);
        for (int place = 0; place < net.placeCount(); place++) {
            bound(new PlaceBounds(net).byStateEquation(place), place, markings);
            bound(answers.bound(place), place, markings);
        }
        if (answers.siphons().holds()) {
            assertThat(markings.stops()).isFalse();
        }
        queries(new StructuralQueries(net, answers), net, markings, random);
        for (int i = 0; i < TRIES; i++) {
            proofs(net, markings, random);
            sums(net, markings, random);
        }
    }

    private static void bound(Optional<MarkingBound> bound, int place, NaiveMarkings markings) {
        bound.ifPresent(weights -> {
            assertThat(weights.mostTokens(place)).isGreaterThanOrEqualTo(markings.most(place));
            for (List<Integer> marking : markings.found()) {
                long sum = weights.weights().times(NaiveMarkings.array(marking));
                assertThat(sum).isLessThanOrEqualTo(weights.most());
                assertThat(!weights.constant() || sum == weights.most()).isTrue();
            }
        });
    }

    private static void queries(StructuralQueries queries, PetriNet net, NaiveMarkings markings, Random random) {
        RandomConditions conditions = new RandomConditions(net, random);
        for (int i = 0; i < QUERIES; i++) {
            MarkingCondition condition = conditions.next(2);
            never(queries.answer(new NetQuery.Reachable(condition)), NetVerdict.NO, condition, markings);
            never(
                    queries.answer(new NetQuery.Invariant(condition)),
                    NetVerdict.YES,
                    new MarkingCondition.Not(condition),
                    markings);
            never(
                    queries.answer(new NetQuery.Deadlock(condition)),
                    NetVerdict.NO,
                    new MarkingCondition.All(
                            List.of(new MarkingCondition.NothingEnabled(net), new MarkingCondition.Not(condition))),
                    markings);
        }
    }

    private static void never(
            Optional<StructuralQueries.Answer> answer,
            NetVerdict verdict,
            MarkingCondition condition,
            NaiveMarkings markings) {
        answer.ifPresent(proved -> {
            assertThat(proved.verdict()).isEqualTo(verdict);
            assertThat(markings.found()).noneMatch(marking -> condition.test(NaiveMarkings.array(marking)));
        });
    }

    /** Numbers that nobody computed: where they count as a proof, no marking fulfils the conditions. */
    private static void proofs(PetriNet net, NaiveMarkings markings, Random random) {
        List<AtLeast> conditions = IntStream.range(0, 1 + random.nextInt(2))
                .mapToObj(i -> {
                    int place = random.nextInt(net.placeCount());
                    return random.nextBoolean()
                            ? LinearCondition.atLeast(place, random.nextInt(4))
                            : LinearCondition.atMost(place, random.nextInt(3));
                })
                .toList();
        long[] factors = random.longs((long) conditions.size() + net.placeCount(), -1, 3)
                .map(factor -> random.nextBoolean() ? factor : 0)
                .toArray();
        RefutedCase numbers = new RefutedCase(conditions, List.of(), List.of(), IntegerVector.of(factors));
        if (numbers.isProof(net, Incidence.of(net))) {
            assertThat(markings.found())
                    .noneMatch(marking ->
                            conditions.stream().allMatch(condition -> condition.holds(NaiveMarkings.array(marking))));
        }
    }

    /** Weights that nobody computed: where they are said never to grow, or to change, no marking has more, or another sum. */
    private static void sums(PetriNet net, NaiveMarkings markings, Random random) {
        IntegerVector weights =
                IntegerVector.of(random.longs(net.placeCount(), 0, 3).toArray());
        long first = weights.times(net.initialMarking());
        if (Incidence.of(net).neverGrows(weights)) {
            assertThat(markings.found()).allMatch(marking -> weights.times(NaiveMarkings.array(marking)) <= first);
        }
        if (Incidence.of(net).neverChanges(weights)) {
            assertThat(markings.found()).allMatch(marking -> weights.times(NaiveMarkings.array(marking)) == first);
        }
    }
}
