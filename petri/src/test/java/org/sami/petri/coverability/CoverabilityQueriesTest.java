package org.sami.petri.coverability;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.LinearComparison;
import org.sami.petri.query.LinearComparison.Relation;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.structure.NaiveMarkings;
import org.sami.petri.structure.SeededNets;

final class CoverabilityQueriesTest {
    @Test
    void whatIsNeverReachedIsNotAmongTheMarkings() {
        int answered = 0;
        int left = 0;
        for (long seed = 0; seed < 1_500; seed++) {
            PetriNet net = SeededNets.withAllArcs(seed, 4, 2);
            Random random = new Random(seed);
            MarkingCondition condition = condition(random, net, 2);
            boolean invariant = random.nextBoolean();
            NetQuery query = invariant
                    ? new NetQuery.Invariant(new MarkingCondition.Not(condition))
                    : new NetQuery.Reachable(condition);
            Optional<CoverabilityQueries.Answer> answer = queries(net).answer(query);
            NaiveMarkings markings = new NaiveMarkings(net, 300);
            boolean seen = markings.found().stream()
                    .anyMatch(marking -> condition.test(
                            marking.stream().mapToInt(Integer::intValue).toArray()));
            if (answer.isPresent()) {
                answered++;
                assertThat(answer.get().verdict()).isEqualTo(invariant ? NetVerdict.YES : NetVerdict.NO);
                assertThat(seen).as("%s of seed %d", condition, seed).isFalse();
            } else if (markings.isComplete() && CoverabilityQueries.mayAnswer(query)) {
                left++;
                assertThat(seen).as("%s of seed %d", condition, seed).isTrue();
            }
        }
        assertThat(answered).isGreaterThan(200);
        assertThat(left).isGreaterThan(50);
    }

    @Test
    void conditionsThatMoreTokensBreakAreLeftToSearches() {
        assertThat(CoverabilityQueries.mayAnswer(new NetQuery.Reachable(sum(Relation.EQUAL, 1))))
                .isFalse();
        assertThat(CoverabilityQueries.mayAnswer(new NetQuery.Reachable(sum(Relation.AT_MOST, 1))))
                .isFalse();
        assertThat(CoverabilityQueries.mayAnswer(new NetQuery.Invariant(sum(Relation.AT_MOST, 1))))
                .isTrue();
        assertThat(CoverabilityQueries.mayAnswer(new NetQuery.Reachable(sum(Relation.AT_LEAST, -1))))
                .isFalse();
        assertThat(CoverabilityQueries.mayAnswer(new NetQuery.Deadlock(new MarkingCondition.Any(List.of()))))
                .isFalse();
    }

    /** More tokens than an int can count are still fewer than any number. */
    @Test
    void anyNumberIsMoreThanEachNumber() {
        NetQuery query = new NetQuery.Reachable(
                new LinearComparison(List.of(new LinearComparison.Term(2, 1)), Relation.MORE, 1L << 40));

        assertThat(queries(OpenNets.producerAndConsumer()).answer(query)).isEmpty();
        assertThat(queries(OpenNets.producerAndConsumer()).answer(new NetQuery.Bound(2)))
                .map(CoverabilityQueries.Answer::words)
                .hasValue("place buffer is unbounded: it grows with each round of make send");
    }

    private static CoverabilityQueries queries(PetriNet net) {
        return new CoverabilityQueries(
                net, CoverabilitySearch.search(net, SearchBudget.ofStates(300), GraphWatch.NONE, System::nanoTime));
    }

    private static LinearComparison sum(Relation relation, int factor) {
        return new LinearComparison(List.of(new LinearComparison.Term(0, factor)), relation, 2);
    }

    private static MarkingCondition condition(Random random, PetriNet net, int depth) {
        int kind = depth == 0 ? random.nextInt(2) : random.nextInt(5);
        if (kind == 0) {
            return new MarkingCondition.Enabled(net, random.nextInt(net.transitionCount()));
        }
        if (kind == 1 || kind == 2) {
            int place = random.nextInt(net.placeCount());
            return new LinearComparison(
                    List.of(new LinearComparison.Term(place, 1 + random.nextInt(2))),
                    random.nextBoolean() ? Relation.AT_LEAST : Relation.MORE,
                    random.nextInt(6));
        }
        List<MarkingCondition> parts = List.of(condition(random, net, depth - 1), condition(random, net, depth - 1));
        return kind == 3 ? new MarkingCondition.All(parts) : new MarkingCondition.Any(parts);
    }
}
