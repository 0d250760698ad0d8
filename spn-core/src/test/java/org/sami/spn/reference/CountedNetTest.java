package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.FiringRule;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetFiring;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.plannet.PlanRun;
import org.sami.spn.testing.TestVocabulary;

/** A net that counts robots reaches the markings of the one that names them, up to an exchange of robots, and names them in a run as that one would. */
class CountedNetTest {
    private static final long SEEDS = 500;
    private static final List<String> ROBOTS = List.of("A", "B", "C");
    private static final int MOST_TRANSITIONS = 400;
    private static final String STANDING = "robots-at.";

    /** Runs of a plan, to the states that were found last. */
    private static final int MOST_RUNS = 40;

    private static final SearchBudget SMALL = new SearchBudget(3_000, 256L << 20, Duration.ofMinutes(15));

    /** What was compared of a seed's plan. */
    private record Compared(long seed, int states, boolean isCopied, String difference) {}

    @Test
    void countedAndNamedRobotsReachTheSame() {
        List<Compared> compared = LongStream.rangeClosed(1, SEEDS)
                .parallel()
                .boxed()
                .flatMap(seed -> Stream.of(RandomPlans.project(seed), NewsPlans.project(seed), CopyPlans.project(seed))
                        .flatMap(project -> compare(seed, project).stream()))
                .toList();

        assertThat(compared.stream().filter(each -> !each.difference().isEmpty()))
                .isEmpty();
        assertThat(compared).hasSizeGreaterThan((int) SEEDS / 4);
        assertThat(compared.stream().filter(each -> each.states() > 5).count()).isGreaterThan(SEEDS / 20);
        assertThat(compared.stream()
                        .filter(each -> each.isCopied() && each.states() > 5)
                        .count())
                .isGreaterThan(SEEDS / 20);
    }

    /** What differs for a seed's plans; empty where nothing does, or no plan's robots can be counted. */
    static Optional<String> difference(long seed) {
        return Stream.of(RandomPlans.project(seed), NewsPlans.project(seed), CopyPlans.project(seed))
                .flatMap(project -> compare(seed, project).stream())
                .map(Compared::difference)
                .filter(difference -> !difference.isEmpty())
                .findFirst();
    }

    private static Optional<Compared> compare(long seed, Project project) {
        PlanNetRequest request = new PlanNetRequest(project, TestVocabulary.TEST, "main", ROBOTS, 2, MOST_TRANSITIONS);
        try {
            Optional<PlanNet> counted = PlanNet.counted(request);
            if (counted.isEmpty()) {
                return Optional.empty();
            }
            PlanNet named = PlanNet.of(request);
            ReachabilityGraph few = search(counted.get());
            ReachabilityGraph many = search(named);
            return few.isComplete() && many.isComplete()
                    ? Optional.of(new Compared(
                            seed, few.states(), isCopied(counted.get()), difference(counted.get(), few, named, many)))
                    : Optional.empty();
        } catch (PlanNetTooLargeException e) {
            return Optional.empty();
        }
    }

    /** Whether robots stand in several places at once, so that they are counted by sets of places. */
    private static boolean isCopied(PlanNet counted) {
        return IntStream.range(0, counted.net().placeCount())
                .anyMatch(place -> counted.net().placeId(place).startsWith(STANDING));
    }

    private static ReachabilityGraph search(PlanNet net) {
        return ReachabilitySearch.explore(net.net(), SearchSettings.within(SMALL));
    }

    private static String difference(PlanNet counted, ReachabilityGraph few, PlanNet named, ReachabilityGraph many) {
        Set<String> less = markings(counted, few);
        Set<String> more = markings(named, many);
        if (!less.equals(more)) {
            Set<String> onlyNamed = new TreeSet<>(more);
            onlyNamed.removeAll(less);
            less.removeAll(more);
            return "only counted " + less + ", only named " + onlyNamed;
        }
        return IntStream.iterate(few.states() - 1, state -> state >= 0, state -> state - 1)
                .limit(MOST_RUNS)
                .mapToObj(state -> run(counted, few, named, state))
                .filter(wrong -> !wrong.isEmpty())
                .findFirst()
                .orElse("");
    }

    private static String run(PlanNet counted, ReachabilityGraph few, PlanNet named, int state) {
        PlanRun run = counted.run(few.runTo(state));
        PlanMarking end = run.markings().get(run.markings().size() - 1);
        return markings(counted, few.marking(state)).equals(merged(counted, end, standingsByName(end)))
                ? replayed(named, run)
                : "the run to state " + state + " ends elsewhere: " + run;
    }

    /** Takes the firings with names on the net that names robots. */
    private static String replayed(PlanNet named, PlanRun run) {
        int[] at = named.net().initialMarking();
        for (int i = 0; i < run.firings().size(); i++) {
            int[] from = at;
            int step = i;
            String goal = run.markings().get(i + 1).toString();
            PlanNetFiring fired = run.firings().get(step);
            boolean isThere =
                    IntStream.range(0, named.net().transitionCount()).anyMatch(t -> isSame(named.firing(t), fired));
            Optional<int[]> next = IntStream.range(0, named.net().transitionCount())
                    .filter(t -> isThere ? isSame(named.firing(t), fired) : isSameButForNames(named.firing(t), fired))
                    .filter(t -> FiringRule.isEnabled(named.net(), t, from))
                    .mapToObj(t -> FiringRule.fire(named.net(), t, from))
                    .filter(to -> named.marking(to).toString().equals(goal))
                    .findFirst();
            if (next.isEmpty()) {
                return "the net with names does not fire " + run.firings().get(i) + " to " + goal;
            }
            at = next.get();
        }
        return "";
    }

    /** Whether they name and move the same tokens, in any order. */
    private static boolean isSame(PlanNetFiring one, PlanNetFiring other) {
        return one.transition().equals(other.transition())
                && Set.copyOf(one.named()).equals(Set.copyOf(other.named()))
                && Set.copyOf(one.moves()).equals(Set.copyOf(other.moves()))
                && one.ends() == other.ends();
    }

    /** Whether they move the same tokens and name as many: of firings that do the same the net keeps one, whomever it names. */
    private static boolean isSameButForNames(PlanNetFiring one, PlanNetFiring other) {
        return isSame(one, new PlanNetFiring(other.transition(), one.named(), other.moves(), other.ends()))
                && one.named().size() == other.named().size();
    }

    private static Set<String> markings(PlanNet net, ReachabilityGraph graph) {
        return IntStream.range(0, graph.states())
                .mapToObj(state -> markings(net, graph.marking(state)))
                .collect(TreeSet::new, Set::add, Set::addAll);
    }

    private static String markings(PlanNet net, int[] marking) {
        return merged(net, net.marking(marking), isCopied(net) ? counted(net, marking) : standings(net, marking));
    }

    /** How many robots stand in just which places, as a counting net says. */
    private static SortedMap<String, Integer> counted(PlanNet net, int[] marking) {
        SortedMap<String, Integer> standings = new TreeMap<>();
        for (int place = 0; place < marking.length; place++) {
            String id = net.net().placeId(place);
            if (id.startsWith(STANDING) && marking[place] > 0) {
                standings.put(id.substring(STANDING.length()), marking[place]);
            }
        }
        return standings;
    }

    /** How many robots stand in just which places, where they have names or stand in one place at most. */
    private static SortedMap<String, Integer> standings(PlanNet net, int[] marking) {
        PlanMarking of = net.marking(marking);
        return net.isCounted() ? standingsOfCounted(of) : standingsByName(of);
    }

    private static SortedMap<String, Integer> standingsOfCounted(PlanMarking marking) {
        SortedMap<String, Integer> standings = new TreeMap<>();
        marking.tokens().forEach((place, here) -> {
            int count = here.getOrDefault(PlanNet.ROBOTS, 0);
            if (count > 0) {
                standings.put(place, count);
            }
        });
        int nowhere = ROBOTS.size()
                - standings.values().stream().mapToInt(Integer::intValue).sum();
        if (nowhere > 0) {
            standings.put("", nowhere);
        }
        return standings;
    }

    private static SortedMap<String, Integer> standingsByName(PlanMarking marking) {
        SortedMap<String, Integer> standings = new TreeMap<>();
        for (String robot : ROBOTS) {
            String places = marking.tokens().entrySet().stream()
                    .filter(here -> here.getValue().containsKey(robot))
                    .map(Map.Entry::getKey)
                    .collect(Collectors.joining("+"));
            standings.merge(places, 1, Integer::sum);
        }
        return standings;
    }

    private static String merged(PlanNet net, PlanMarking marking, SortedMap<String, Integer> standings) {
        SortedMap<String, SortedMap<String, Integer>> merged = new TreeMap<>();
        marking.tokens()
                .forEach((place, here) -> here.forEach((token, count) -> merged.computeIfAbsent(
                                place, p -> new TreeMap<>())
                        .merge(net.isRobot(token) || ROBOTS.contains(token) ? "robots" : token, count, Integer::sum)));
        return merged + " " + marking.nobody() + " " + marking.running() + " " + standings;
    }
}
