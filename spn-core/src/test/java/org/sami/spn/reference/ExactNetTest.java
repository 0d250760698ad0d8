package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.testing.TestVocabulary;

/**
 * Where the net of a plan leaves nothing open but which input events come, its graph has exactly the markings that the engine reaches when every event may come with
 * every name. Both are searched whole, on random small plans.
 */
class ExactNetTest {
    private static final long SEEDS = 400;
    private static final List<String> ROBOTS = List.of("A", "B");
    private static final SearchBudget SMALL = new SearchBudget(2_000, 256L << 20, Duration.ofMinutes(15));

    /** What the two searches found. */
    private record Compared(long seed, Set<String> ofTheEngine, Set<String> ofTheNet) {
        String difference() {
            Set<String> more = new TreeSet<>(ofTheNet);
            more.removeAll(ofTheEngine);
            Set<String> less = new TreeSet<>(ofTheEngine);
            less.removeAll(ofTheNet);
            return more.isEmpty() && less.isEmpty()
                    ? ""
                    : "seed " + seed + ": only the net reaches " + more + ", only the engine " + less;
        }
    }

    @Test
    void graphOfANetThatAbstractsNothingIsTheEngines() {
        List<Compared> compared = LongStream.rangeClosed(1, SEEDS)
                .parallel()
                .boxed()
                .flatMap(ExactNetTest::compare)
                .toList();

        assertThat(compared.stream().map(Compared::difference).filter(text -> !text.isEmpty()))
                .isEmpty();
        assertThat(compared).hasSizeGreaterThan((int) SEEDS / 4);
        assertThat(compared.stream().filter(each -> each.ofTheNet().size() > 3).count())
                .isGreaterThan(SEEDS / 10);
    }

    /** What the two searches of a seed's plan do not have in common; empty where they agree, or the net is not exact. */
    static Optional<String> difference(long seed) {
        return compare(seed)
                .map(Compared::difference)
                .filter(text -> !text.isEmpty())
                .findFirst();
    }

    private static Stream<Compared> compare(long seed) {
        return Stream.of(NewsPlans.project(seed), CopyPlans.project(seed))
                .flatMap(project -> compare(seed, project).stream());
    }

    private static Optional<Compared> compare(long seed, Project project) {
        PlanNet net;
        try {
            net = PlanNet.of(new PlanNetRequest(project, TestVocabulary.TEST, "main", ROBOTS));
        } catch (PlanNetTooLargeException e) {
            return Optional.empty();
        }
        ReachabilityGraph graph = ReachabilitySearch.explore(net.net(), SearchSettings.within(SMALL));
        boolean isExact = graph.isComplete()
                && graph.mostTokens(net.beyond()) == 0
                && net.abstractions().stream().allMatch(a -> a.text().contains("\" may come at \""));
        return isExact
                ? Optional.of(new Compared(
                        seed, new EngineMarkings(net, NewsPlans.EVENTS).all(new Dice(seed)), markings(net, graph)))
                : Optional.empty();
    }

    /** All markings of a graph in words. */
    static Set<String> markings(PlanNet net, ReachabilityGraph graph) {
        Set<String> all = new TreeSet<>();
        for (int state = 0; state < graph.states(); state++) {
            all.add(net.marking(graph.marking(state)).tokens().toString());
        }
        return all;
    }
}
