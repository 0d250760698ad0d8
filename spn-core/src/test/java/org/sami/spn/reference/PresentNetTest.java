package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.petri.coverability.SaturatedQueries;
import org.sami.petri.coverability.SaturatedSearch;
import org.sami.petri.coverability.WiderNet;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.FiringRule;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.query.QueryFaultException;
import org.sami.petri.query.QueryMeans;
import org.sami.petri.query.QueryParser;
import org.sami.petri.query.QueryRunner;
import org.sami.petri.symmetry.NetSymmetry;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetPlace;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanNetNames;
import org.sami.spn.testing.TestVocabulary;

/**
 * A net that follows only whether any robots are in a place has the image of each marking of the net that names them, and the firings that it calls sure are those that each
 * such marking can do. Queries are answered the same by both. More seeds: {@code ./gradlew :spn-core:test --tests '*PresentNetTest' -Pseeds=500}.
 */
class PresentNetTest {
    private static final long SEEDS = Long.getLong("spn.seeds", 150);
    private static final List<String> ROBOTS = List.of("A", "B", "C");
    private static final int MOST_TRANSITIONS = 400;

    /** Markings of the net with names of which each sure firing is tried. */
    private static final int MOST_TRIED = 60;

    private static final String BOUND_OF_ROBOTS = "bound p1.robots";

    private static final List<String> QUERIES = List.of(
            "deadlock",
            "home ended",
            "reachable m(p1.robots) >= 1 and m(p2.robots) = 0",
            "reachable m(p1.robots) = 0 and m(p3) >= 1",
            "invariant m(p1.robots) + m(p2.robots) < 1",
            "reachable m(p1.robots) >= 2",
            "home m(p1.robots) = 0",
            "bound p0.generic",
            BOUND_OF_ROBOTS);

    private static final SearchBudget SMALL = new SearchBudget(3_000, 256L << 20, Duration.ofMinutes(15));

    /** What was compared of a seed's plan. */
    private record Compared(long seed, int states, int sure, int answered, String difference) {}

    @Test
    void eachMarkingHasItsImageAndEachSureFiringIsDone() {
        List<Compared> compared = LongStream.rangeClosed(1, SEEDS)
                .parallel()
                .boxed()
                .flatMap(PresentNetTest::compare)
                .toList();

        assertThat(compared.stream().filter(each -> !each.difference().isEmpty()))
                .isEmpty();
        assertThat(compared).hasSizeGreaterThan((int) SEEDS / 5);
        assertThat(compared.stream()
                        .filter(each -> each.states() > 5 && each.sure() > 0)
                        .count())
                .isGreaterThan(SEEDS / 10);
        assertThat(compared.stream().mapToInt(Compared::answered).sum()).isGreaterThan((int) SEEDS);
    }

    /** What differs for a seed's plans; empty where nothing does, or no plan's robots are copied so that they lose count. */
    static Optional<String> difference(long seed) {
        return compare(seed)
                .map(Compared::difference)
                .filter(difference -> !difference.isEmpty())
                .findFirst();
    }

    private static Stream<Compared> compare(long seed) {
        return Stream.of(RandomPlans.project(seed), NewsPlans.project(seed), CopyPlans.project(seed))
                .flatMap(project -> compare(seed, project).stream());
    }

    private static Optional<Compared> compare(long seed, Project project) {
        PlanNetRequest request = new PlanNetRequest(project, TestVocabulary.TEST, "main", ROBOTS, 2, MOST_TRANSITIONS);
        try {
            Optional<PlanNet> present = PlanNet.present(request);
            if (present.isEmpty()) {
                return Optional.empty();
            }
            PlanNet named = PlanNet.of(request);
            ReachabilityGraph few = search(present.get());
            ReachabilityGraph many = search(named);
            return few.isComplete() && many.isComplete()
                    ? Optional.of(compared(seed, present.get(), few, named, many))
                    : Optional.empty();
        } catch (PlanNetTooLargeException e) {
            return Optional.empty();
        }
    }

    private static ReachabilityGraph search(PlanNet net) {
        return ReachabilitySearch.explore(net.net(), SearchSettings.within(SMALL));
    }

    private static Compared compared(
            long seed, PlanNet present, ReachabilityGraph few, PlanNet named, ReachabilityGraph many) {
        Images images = new Images(present, named);
        Set<String> known = new HashSet<>();
        IntStream.range(0, few.states()).forEach(state -> known.add(Arrays.toString(few.marking(state))));
        Optional<String> lost = IntStream.range(0, many.states())
                .mapToObj(many::marking)
                .filter(marking -> !known.contains(Arrays.toString(images.of(marking))))
                .map(marking -> "no image of " + named.marking(marking))
                .findFirst();
        Optional<String> unsure = IntStream.range(0, Math.min(MOST_TRIED, many.states()))
                .mapToObj(many::marking)
                .flatMap(marking -> present.sure().stream()
                        .filter(t -> !images.does(t, marking))
                        .mapToObj(t -> present.net().transitionId(t) + " is not sure at " + named.marking(marking)))
                .findFirst();
        List<String> wrong = new ArrayList<>();
        int answered = answered(present, named, wrong);
        return new Compared(
                seed,
                many.states(),
                present.sure().cardinality(),
                answered,
                lost.or(() -> unsure).or(() -> wrong.stream().findFirst()).orElse(""));
    }

    /** How many queries the small net answers; what is wrong is added. */
    private static int answered(PlanNet present, PlanNet named, List<String> wrong) {
        SaturatedSearch search = new SaturatedSearch(
                new WiderNet(present.net(), present.presence(), present.sure()),
                present.uncounted(),
                SMALL,
                net -> NetSymmetry.of(net, List.of()),
                GraphWatch.NONE,
                System::nanoTime);
        Optional<SaturatedQueries> few = search.saturated(search.exact());
        QueryRunner many = new QueryRunner(
                named.net(), SMALL, new QueryMeans(false, Optional.empty()), GraphWatch.NONE, System::nanoTime);
        many.whole();
        int answered = 0;
        for (String text : QUERIES) {
            Optional<NetQuery> asked = query(present, text);
            Optional<QueryAnswer> answer = asked.flatMap(query -> few.flatMap(queries -> queries.answer(query)));
            if (answer.isPresent()) {
                NetVerdict right = many.answer(query(named, text).orElseThrow()).verdict();
                answered++;
                if (text.equals(BOUND_OF_ROBOTS)
                        && present.net().place("p1.robots").isPresent()) {
                    wrong.add("robots are not counted, and have a bound");
                }
                if (answer.get().verdict() != right) {
                    wrong.add(text + " is " + right + ", not " + answer.get().verdict());
                }
            }
        }
        return answered;
    }

    /** What a text means; empty where a place that it names has no tokens in this plan. */
    private static Optional<NetQuery> query(PlanNet net, String text) {
        try {
            return Optional.of(QueryParser.query(net.net(), new PlanNetNames(net), text));
        } catch (QueryFaultException fault) {
            return Optional.empty();
        }
    }

    /** Markings of the net that names robots in the net that follows whether there are any. */
    private static final class Images {
        private final PlanNet present;
        private final PlanNet named;
        private final int[] image;

        Images(PlanNet present, PlanNet named) {
            this.present = present;
            this.named = named;
            image = IntStream.range(0, named.net().placeCount())
                    .map(place -> {
                        PlanNetPlace of = named.place(place);
                        return named.isRobot(of.token()) && of.role() == PlanNetPlace.Role.TOKEN
                                ? present.net()
                                        .place(of.planPlace() + "." + PlanNet.ROBOTS)
                                        .orElseThrow()
                                : present.net()
                                        .place(named.net().placeId(place))
                                        .orElseThrow();
                    })
                    .toArray();
        }

        int[] of(int[] marking) {
            int[] of = new int[present.net().placeCount()];
            for (int place = 0; place < marking.length; place++) {
                of[image[place]] = named.isRobot(named.place(place).token())
                        ? Math.max(of[image[place]], marking[place])
                        : marking[place];
            }
            return of;
        }

        /** Whether the net with names does what a transition does, where it is enabled at the image of a marking. */
        boolean does(int transition, int[] marking) {
            int[] from = of(marking);
            if (!FiringRule.isEnabled(present.net(), transition, from)) {
                return true;
            }
            int[] goal = FiringRule.fire(present.net(), transition, from);
            OptionalInt found = IntStream.range(0, named.net().transitionCount())
                    .filter(t -> named.firing(t)
                            .transition()
                            .equals(present.firing(transition).transition()))
                    .filter(t -> FiringRule.isEnabled(named.net(), t, marking))
                    .filter(t -> Arrays.equals(goal, of(FiringRule.fire(named.net(), t, marking))))
                    .findFirst();
            return found.isPresent();
        }
    }
}
