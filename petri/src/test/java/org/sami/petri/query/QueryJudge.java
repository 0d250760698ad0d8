package org.sami.petri.query;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import java.util.function.LongConsumer;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.PlainExplorer;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.structure.SeededNets;
import org.sami.petri.symmetry.CopiedNets;
import org.sami.petri.symmetry.NetSymmetry;

/** Compares the answers to random queries about a seed's random net with what a plain explorer saw: from whole searches, and from some that a budget ends. */
public final class QueryJudge implements LongConsumer {
    private static final int MOST = 400;
    private static final int QUERIES = 5;
    private static final int KINDS = 3;

    private PetriNet net;
    private PlainExplorer plain;
    private boolean isWhole;

    /** Nothing is judged yet. */
    public QueryJudge() {}

    @Override
    public void accept(long seed) {
        net = seed % KINDS == 0
                ? SeededNets.withAllArcs(seed, 5, 2)
                : seed % KINDS == 1 ? CopiedNets.net(seed) : CopiedNets.nearly(seed / KINDS);
        plain = new PlainExplorer(net, MOST);
        if (!plain.isComplete()) {
            return;
        }
        Random random = new Random(seed);
        isWhole = random.nextInt(3) > 0;
        Optional<NetSymmetry> symmetry = random.nextBoolean() ? Optional.of(NetSymmetry.of(net)) : Optional.empty();
        QueryRunner runner = new QueryRunner(
                net,
                SearchBudget.ofStates(isWhole ? MOST : 1 + random.nextInt(plain.distances.size())),
                new QueryMeans(random.nextBoolean(), symmetry),
                GraphWatch.NONE,
                System::nanoTime);
        if (random.nextInt(3) == 0) {
            runner.whole();
        }
        RandomConditions conditions = new RandomConditions(net, random);
        for (int i = 0; i < QUERIES; i++) {
            MarkingCondition condition = conditions.next(2);
            switch (random.nextInt(6)) {
                case 0 -> first(runner.answer(new NetQuery.Reachable(condition)), NetVerdict.YES, condition);
                case 1 ->
                    first(
                            runner.answer(new NetQuery.Invariant(condition)),
                            NetVerdict.NO,
                            new MarkingCondition.Not(condition));
                case 2 ->
                    first(
                            runner.answer(new NetQuery.Deadlock(condition)),
                            NetVerdict.YES,
                            new MarkingCondition.All(List.of(
                                    new MarkingCondition.NothingEnabled(net), new MarkingCondition.Not(condition))));
                case 3 -> home(runner.answer(new NetQuery.Home(condition)), condition);
                case 4 -> {
                    int place = random.nextInt(net.placeCount());
                    most(runner.answer(new NetQuery.Bound(place)), List.of(new LinearComparison.Term(place, 1)));
                }
                default -> {
                    List<LinearComparison.Term> terms = List.of(
                            new LinearComparison.Term(random.nextInt(net.placeCount()), 1),
                            new LinearComparison.Term(random.nextInt(net.placeCount()), random.nextInt(4) - 1));
                    most(runner.answer(new NetQuery.BoundOfSum(terms, 0, "sum")), terms);
                }
            }
        }
    }

    /** A marking that is found is the nearest, where all could be looked at. */
    private void first(QueryAnswer answer, NetVerdict whenFound, MarkingCondition goal) {
        OptionalInt nearest = plain.distances.entrySet().stream()
                .filter(marking -> goal.test(array(marking.getKey())))
                .mapToInt(Map.Entry::getValue)
                .min();
        NetVerdict never = whenFound == NetVerdict.YES ? NetVerdict.NO : NetVerdict.YES;
        verdict(answer, nearest.isPresent() ? whenFound : never);
        assertThat(answer.witness().isPresent()).isEqualTo(answer.verdict() == whenFound);
        answer.witness().ifPresent(run -> {
            assertThat(goal.test(run.replay(net))).isTrue();
            if (!answer.words().contains("there may be a nearer one")) {
                assertThat(run.transitions()).hasSize(nearest.getAsInt());
            }
        });
    }

    private void home(QueryAnswer answer, MarkingCondition condition) {
        Set<List<Integer>> reaching = plain.reaching(marking -> condition.test(array(marking)));
        OptionalInt nearest = plain.distances.entrySet().stream()
                .filter(marking -> !reaching.contains(marking.getKey()))
                .mapToInt(Map.Entry::getValue)
                .min();
        verdict(answer, nearest.isPresent() ? NetVerdict.NO : NetVerdict.YES);
        answer.witness().ifPresent(run -> {
            assertThat(reaching).doesNotContain(PlainExplorer.list(run.replay(net)));
            assertThat(run.transitions()).hasSize(nearest.getAsInt());
        });
    }

    private void most(QueryAnswer answer, List<LinearComparison.Term> terms) {
        long most = plain.distances.keySet().stream()
                .mapToLong(marking -> of(terms, array(marking)))
                .max()
                .getAsLong();
        verdict(answer, NetVerdict.YES);
        long shown = of(terms, answer.witness().orElseThrow().replay(net));
        assertThat(shown).isLessThanOrEqualTo(most);
        if (answer.verdict() == NetVerdict.YES) {
            assertThat(shown).isEqualTo(most);
        }
        assertThat(answer.words()).contains((answer.verdict() == NetVerdict.YES ? "at most " : "up to ") + shown);
    }

    private void verdict(QueryAnswer answer, NetVerdict right) {
        if (isWhole || answer.verdict() != NetVerdict.UNKNOWN) {
            assertThat(answer.verdict()).isEqualTo(right);
        }
    }

    private static long of(List<LinearComparison.Term> terms, int[] marking) {
        return new NetQuery.BoundOfSum(terms, 0, "sum").of(marking);
    }

    private static int[] array(List<Integer> marking) {
        return marking.stream().mapToInt(Integer::intValue).toArray();
    }
}
