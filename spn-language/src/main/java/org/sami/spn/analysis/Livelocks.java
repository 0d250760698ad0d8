package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Action;
import org.sami.spn.model.Match;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/**
 * A ring of transitions without input events can fire without end, and the engine then halts the mission (R-LOOK-9). A ring that waits for a sub-mission, or that consumes tokens on its way, comes to rest; one that closes
 * over an edge which asks only that tokens are absent is none, since who enters there keeps the transition from firing. Rings that
 * share a transition are reported as one.
 */
final class Livelocks implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-LIVELOCK",
                "The ring can fire without end in one moment; the mission is then halted.",
                "Let a transition of the ring wait for an input event, or take a token out of the ring."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        Map<String, List<String>> next = new LinkedHashMap<>();
        for (Transition t : plan.plan().transitions()) {
            if (free(plan, t)) {
                next.put(t.id(), new ArrayList<>());
            }
        }
        Map<String, List<String>> before = new LinkedHashMap<>();
        next.keySet().forEach(id -> before.put(id, new ArrayList<>()));
        next.forEach((id, following) -> {
            for (Place place : plan.outPlaces(plan.transition(id).orElseThrow())) {
                plan.outTransitions(place).stream()
                        .filter(t -> !inhibited(plan, place, t))
                        .map(Transition::id)
                        .filter(next::containsKey)
                        .forEach(following::add);
            }
            following.forEach(
                    f -> before.computeIfAbsent(f, fresh -> new ArrayList<>()).add(id));
        });
        Set<String> done = new HashSet<>();
        for (String id : next.keySet()) {
            Set<String> ring = reached(next, id);
            if (!done.contains(id) && ring.contains(id)) {
                ring.retainAll(reached(before, id));
                done.addAll(ring);
                report(plan, id, ring, report);
            }
        }
    }

    /** Whether a transition asks of a place only that tokens are absent. */
    private static boolean inhibited(PlanContext plan, Place place, Transition t) {
        return plan.inEdges(t).stream()
                .filter(e -> e.place().equals(place.id()))
                .allMatch(e -> !e.requirements().isEmpty()
                        && e.requirements().stream().allMatch(r -> r.match() == Match.ZERO));
    }

    /** Whether a transition waits for nothing from outside and uses nothing up. */
    private static boolean free(PlanContext plan, Transition t) {
        return t.inputs().isEmpty()
                && plan.inPlaces(t).stream().allMatch(p -> p.subMissions().isEmpty())
                && plan.outEdges(t).stream()
                        .flatMap(e -> e.requirements().stream())
                        .noneMatch(r -> r.action() == Action.CONSUME);
    }

    /** What can be reached in one step or more; the beginning itself where a ring closes. */
    private static Set<String> reached(Map<String, List<String>> steps, String begin) {
        Set<String> found = new HashSet<>();
        Deque<String> open = new ArrayDeque<>(List.of(begin));
        while (!open.isEmpty()) {
            steps.getOrDefault(open.pop(), List.of()).stream()
                    .filter(found::add)
                    .forEach(open::push);
        }
        return found;
    }

    private static void report(PlanContext plan, String first, Set<String> ring, Consumer<Finding> report) {
        Transition t = plan.transition(first).orElseThrow();
        String[] ids = plan.plan().transitions().stream()
                .map(Transition::id)
                .filter(ring::contains)
                .toArray(String[]::new);
        report.accept(Finding.warning(
                "W-LIVELOCK",
                plan.at(t),
                "The " + plan.name(t)
                        + " stands in a ring of transitions without input events, which may fire without end",
                ids));
    }
}
