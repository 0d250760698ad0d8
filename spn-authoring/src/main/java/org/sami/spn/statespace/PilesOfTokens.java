package org.sami.spn.statespace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Project;
import org.sami.spn.stepping.NextStep;

/**
 * Ways on which tokens pile up: between a state and a later one, again between that and a third, and so on until there are more than any
 * requirement counts to, the same tokens are added to the same places and nothing is taken away. What was done there can be done forever, unless a
 * timer ends it that has run all the while.
 */
final class PilesOfTokens {
    /**
     * A pile.
     *
     * @param what which tokens pile up where, as {@link Node#counts} says it
     * @param byItself whether nobody's news, failure or button is needed for it
     */
    record Pile(Node node, Set<String> what, boolean byItself) {
        /** Where tokens pile up. */
        Set<String> places() {
            return what.stream().map(one -> one.substring(0, one.indexOf(": "))).collect(Collectors.toSet());
        }
    }

    private static final int LEAST_ROUNDS = 2;

    private final List<Pile> all = new ArrayList<>();
    private final int rounds;

    /** Piles of the plans of a project. */
    PilesOfTokens(Project project) {
        int most = project.plans().stream()
                .flatMap(plan -> plan.inEdges().stream())
                .flatMap(edge -> edge.requirements().stream())
                .mapToInt(InRequirement::n)
                .max()
                .orElse(0);
        rounds = Math.max(LEAST_ROUNDS, most + 1);
    }

    /** Whether tokens pile up on the way to a state; that is noted. */
    boolean isPile(Node node) {
        Map<String, Integer> now = node.counts();
        int total = total(now);
        Set<Map<String, Integer>> growths = new LinkedHashSet<>();
        boolean byItself = true;
        Node at = node;
        while (at.first().isPresent()) {
            Node.Edge edge = at.first().get();
            byItself &= isExpected(edge.step().kind());
            at = edge.from();
            if (total(at.counts()) < total && !node.isTimedSince(at)) {
                Optional<Map<String, Integer>> growth = growth(at.counts(), now);
                if (growth.isPresent() && growths.add(growth.get()) && isOfEqualRounds(growth.get(), growths)) {
                    all.add(new Pile(node, new TreeSet<>(growth.get().keySet()), byItself));
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether the growth is so many times another, and all numbers of times below are there too. */
    private boolean isOfEqualRounds(Map<String, Integer> growth, Set<Map<String, Integer>> growths) {
        return growths.stream()
                .filter(one -> growth.equals(times(one, rounds)))
                .anyMatch(one -> IntStream.range(LEAST_ROUNDS, rounds).allMatch(i -> growths.contains(times(one, i))));
    }

    private static Map<String, Integer> times(Map<String, Integer> growth, int times) {
        Map<String, Integer> more = new HashMap<>(growth);
        more.replaceAll((what, count) -> count * times);
        return more;
    }

    private static boolean isExpected(NextStep.Kind kind) {
        return kind == NextStep.Kind.DECISION || kind == NextStep.Kind.ANSWER || kind == NextStep.Kind.TIME;
    }

    private static int total(Map<String, Integer> counts) {
        return counts.values().stream().mapToInt(Integer::intValue).sum();
    }

    /** What there is more of; empty where there is less of anything. */
    private static Optional<Map<String, Integer>> growth(Map<String, Integer> before, Map<String, Integer> after) {
        Map<String, Integer> growth = new HashMap<>(after);
        for (Map.Entry<String, Integer> entry : before.entrySet()) {
            int more = after.getOrDefault(entry.getKey(), 0) - entry.getValue();
            if (more < 0) {
                return Optional.empty();
            }
            growth.put(entry.getKey(), more);
        }
        growth.values().removeIf(more -> more == 0);
        return growth.isEmpty() ? Optional.empty() : Optional.of(growth);
    }

    List<Pile> all() {
        return all;
    }
}
