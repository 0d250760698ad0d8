package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/** Every place and transition can be reached along edges, from the start or from a transition that waits for news alone. */
final class Reachability implements PlanCheck {
    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        if (plan.plan().startPlace().isEmpty()) {
            return;
        }
        Set<String> reached = from(plan);
        for (Place place : plan.plan().places()) {
            if (!reached.contains(place.id())) {
                report.accept(Finding.warning(
                        "W-UNREACHABLE",
                        plan.at(place),
                        "Nothing leads to the " + PlanContext.name(place),
                        place.id()));
            }
        }
        for (Transition t : plan.plan().transitions()) {
            if (!reached.contains(t.id()) && !plan.inEdges(t).isEmpty()) {
                report.accept(Finding.warning(
                        "W-UNREACHABLE", plan.at(t), "Nothing leads to the " + PlanContext.name(t), t.id()));
            }
        }
    }

    /** Ids of the vertices that can be reached, requirements and events disregarded. */
    static Set<String> from(PlanContext plan) {
        Deque<String> open = new ArrayDeque<>();
        plan.plan().places().stream().filter(Place::start).map(Place::id).forEach(open::add);
        for (Transition t : plan.plan().transitions()) {
            if (plan.inEdges(t).isEmpty() && !t.inputs().isEmpty()) {
                open.add(t.id());
            }
        }
        Set<String> reached = new LinkedHashSet<>();
        while (!open.isEmpty()) {
            String vertex = open.pop();
            if (reached.add(vertex)) {
                open.addAll(next(plan, vertex));
            }
        }
        return reached;
    }

    private static List<String> next(PlanContext plan, String vertex) {
        return plan.transition(vertex)
                .map(t -> plan.outPlaces(t).stream().map(Place::id).toList())
                .or(() -> plan.place(vertex)
                        .map(p -> plan.outTransitions(p).stream()
                                .map(Transition::id)
                                .toList()))
                .orElse(List.of());
    }
}
