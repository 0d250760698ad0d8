package org.sami.petri.coverability;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.LongConsumer;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.query.RandomConditions;
import org.sami.petri.structure.NaiveMarkings;
import org.sami.petri.structure.SeededNets;

/** Compares the coverability set of a seed's random net with the tree of Karp and Miller, or with its markings, and what queries are told from it. */
public final class CoverabilityJudge implements LongConsumer {
    private static final int QUERIES = 4;

    /** Nothing is judged yet. */
    public CoverabilityJudge() {}

    @Override
    public void accept(long seed) {
        PetriNet net = seed % 2 == 0 ? SeededNets.plain(seed, 5, 3) : SeededNets.withAllArcs(seed, 4, 2);
        Optional<Set<List<Integer>>> tree = net.isPlain() ? PlainKarpMiller.set(net, 2_000) : Optional.empty();
        CoverabilitySet set = CoverabilitySearch.search(
                net, SearchBudget.ofStates(tree.isPresent() ? 100_000 : 300), GraphWatch.NONE, System::nanoTime);
        NaiveMarkings markings = new NaiveMarkings(net, 300);
        tree.ifPresent(expected -> {
            assertThat(set.isComplete()).isTrue();
            assertThat(markings(set)).isEqualTo(expected);
        });
        if (markings.isComplete()) {
            assertThat(set.isComplete()).isTrue();
            for (int place = 0; place < net.placeCount(); place++) {
                assertThat(set.mostTokens(place)).hasValue(markings.most(place));
            }
        }
        if (set.isComplete()) {
            compare(net, set, markings);
            queries(net, set, markings, new Random(seed));
        }
        for (int place = 0; place < net.placeCount(); place++) {
            int grows = place;
            set.pump(place).ifPresent(pump -> {
                assertThat(set.isUnbounded(grows)).isTrue();
                pumps(net, pump, grows);
            });
        }
    }

    private static void compare(PetriNet net, CoverabilitySet set, NaiveMarkings markings) {
        for (List<Integer> marking : markings.found()) {
            assertThat(markings(set)).anyMatch(large -> covers(net, large, marking));
        }
        for (int t = 0; t < net.transitionCount(); t++) {
            int transition = t;
            boolean fires = markings.found().stream().anyMatch(m -> NaiveMarkings.enabled(net, m, transition));
            assertThat(set.canFire(t)).isIn(fires, fires || !markings.isComplete());
        }
    }

    private static void queries(PetriNet net, CoverabilitySet set, NaiveMarkings markings, Random random) {
        RandomConditions conditions = new RandomConditions(net, random);
        CoverabilityQueries answers = new CoverabilityQueries(net, set);
        for (int i = 0; i < QUERIES; i++) {
            MarkingCondition condition = conditions.next(2);
            answers.answer(new NetQuery.Reachable(condition)).ifPresent(answer -> {
                assertThat(answer.verdict()).isEqualTo(NetVerdict.NO);
                assertThat(markings.found()).noneMatch(marking -> condition.test(array(marking)));
            });
            answers.answer(new NetQuery.Invariant(condition)).ifPresent(answer -> {
                assertThat(answer.verdict()).isEqualTo(NetVerdict.YES);
                assertThat(markings.found()).allMatch(marking -> condition.test(array(marking)));
            });
        }
    }

    /** The repetition can be fired three times after its lead, and adds to the place each time. */
    private static void pumps(PetriNet net, CoverabilitySet.Pump pump, int place) {
        List<Integer> marking = Arrays.stream(net.initialMarking()).boxed().toList();
        marking = fired(net, marking, pump.lead());
        for (int round = 0; round < 3; round++) {
            int before = marking.get(place);
            marking = fired(net, marking, pump.repeated());
            assertThat(marking.get(place)).isGreaterThan(before);
        }
    }

    private static List<Integer> fired(PetriNet net, List<Integer> from, List<Integer> transitions) {
        List<Integer> marking = from;
        for (int transition : transitions) {
            assertThat(NaiveMarkings.enabled(net, marking, transition)).isTrue();
            marking = NaiveMarkings.fired(net, marking, transition);
        }
        return marking;
    }

    private static boolean covers(PetriNet net, List<Integer> large, List<Integer> small) {
        for (int place = 0; place < small.size(); place++) {
            boolean isExact = false;
            for (int t = 0; t < net.transitionCount(); t++) {
                isExact |= net.inhibitors().weight(t, place) + net.resets().weight(t, place) > 0;
            }
            if (large.get(place) < small.get(place)
                    || (isExact && !large.get(place).equals(small.get(place)))) {
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
        assertThat(markings).hasSize(set.size());
        return markings;
    }

    private static int[] array(List<Integer> marking) {
        return marking.stream().mapToInt(Integer::intValue).toArray();
    }
}
