package org.sami.spn.phase;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Match;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * Which vertices of a plan lie behind which. An in edge that asks only for absence leads nowhere, as no token goes along it, unless
 * nothing else leads to its transition.
 */
final class VertexGraph {
    private final Map<String, Set<String>> after = new LinkedHashMap<>();
    private final Map<String, Set<String>> before = new LinkedHashMap<>();
    private final List<String> first = new ArrayList<>();

    VertexGraph(Plan plan) {
        plan.places().forEach(place -> add(place.id()));
        plan.transitions().forEach(transition -> add(transition.id()));
        plan.inEdges().stream()
                .filter(edge -> !asksForAbsence(edge))
                .forEach(edge -> connect(edge.place(), edge.transition()));
        plan.inEdges().stream()
                .filter(VertexGraph::asksForAbsence)
                .filter(edge -> plan.inEdges().stream()
                        .noneMatch(other -> other.transition().equals(edge.transition()) && !asksForAbsence(other)))
                .forEach(edge -> connect(edge.place(), edge.transition()));
        plan.outEdges().forEach(edge -> connect(edge.transition(), edge.place()));
        plan.places().stream().filter(Place::start).map(Place::id).forEach(first::add);
        plan.transitions().stream()
                .map(Transition::id)
                .filter(id -> next(before, id).isEmpty())
                .forEach(first::add);
    }

    private static boolean asksForAbsence(InEdge edge) {
        return !edge.requirements().isEmpty()
                && edge.requirements().stream().allMatch(requirement -> requirement.match() == Match.ZERO);
    }

    private void add(String vertex) {
        after.put(vertex, new LinkedHashSet<>());
        before.put(vertex, new LinkedHashSet<>());
    }

    /** An edge without one of its ends, as a plan that is being drawn may have, connects nothing. */
    private void connect(String from, String to) {
        if (after.containsKey(from) && after.containsKey(to)) {
            next(after, from).add(to);
            next(before, to).add(from);
        }
    }

    private static Set<String> next(Map<String, Set<String>> edges, String vertex) {
        return Objects.requireNonNull(edges.get(vertex), vertex);
    }

    /** The matching vertices that are reached first from where missions begin: start places, and transitions without in place. */
    List<String> nearestFromStart(Predicate<String> wanted) {
        return search(first, after, wanted);
    }

    /** The matching vertices behind a vertex without another one between. */
    List<String> nearestAfter(String vertex, Predicate<String> wanted) {
        return search(next(after, vertex), after, wanted);
    }

    /** The matching vertices before a vertex with the fewest steps to it. */
    List<String> nearestBefore(String vertex, Predicate<String> wanted) {
        Set<String> seen = new LinkedHashSet<>(Set.of(vertex));
        Set<String> ring = next(before, vertex);
        while (!ring.isEmpty()) {
            List<String> found = ring.stream().filter(wanted).toList();
            if (!found.isEmpty()) {
                return found;
            }
            seen.addAll(ring);
            Set<String> further = new LinkedHashSet<>();
            ring.forEach(
                    v -> next(before, v).stream().filter(b -> !seen.contains(b)).forEach(further::add));
            ring = further;
        }
        return List.of();
    }

    private static List<String> search(
            Collection<String> from, Map<String, Set<String>> edges, Predicate<String> wanted) {
        List<String> found = new ArrayList<>();
        Set<String> seen = new LinkedHashSet<>(from);
        Deque<String> open = new ArrayDeque<>(seen);
        while (!open.isEmpty()) {
            String vertex = open.remove();
            if (wanted.test(vertex)) {
                found.add(vertex);
            } else {
                next(edges, vertex).stream().filter(seen::add).forEach(open::add);
            }
        }
        return found;
    }
}
