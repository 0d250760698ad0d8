package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Action;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/**
 * A ring of transitions without input events can fire without end, and the engine then halts the mission (SEMANTICS, When a
 * transition is looked at). A ring that waits for a sub-mission, or that consumes tokens on its way, comes to rest.
 */
final class Livelocks implements PlanCheck {
    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            if (free(plan, t) && follows(plan, t).contains(t)) {
                report.accept(Finding.warning(
                        "W-LIVELOCK",
                        plan.at(t),
                        "The " + PlanContext.name(t)
                                + " stands in a ring of transitions without input events, which may fire without end",
                        t.id()));
            }
        }
    }

    /** Whether a transition waits for nothing from outside and uses nothing up. */
    private static boolean free(PlanContext plan, Transition t) {
        return t.inputs().isEmpty()
                && plan.inPlaces(t).stream().allMatch(p -> p.subMissions().isEmpty())
                && plan.outEdges(t).stream()
                        .flatMap(e -> e.requirements().stream())
                        .noneMatch(r -> r.action() == Action.CONSUME);
    }

    /** The free transitions that can fire in turn after one, itself included where the ring closes. */
    private static Set<Transition> follows(PlanContext plan, Transition first) {
        Set<Transition> found = new HashSet<>();
        Deque<Transition> open = new ArrayDeque<>(List.of(first));
        while (!open.isEmpty()) {
            for (Place place : plan.outPlaces(open.pop())) {
                plan.outTransitions(place).stream()
                        .filter(next -> free(plan, next) && found.add(next))
                        .forEach(open::push);
            }
        }
        return found;
    }
}
