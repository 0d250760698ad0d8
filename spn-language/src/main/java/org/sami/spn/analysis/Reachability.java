package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/** Every place and transition can be reached along edges, from the start or from a transition that waits for news alone. */
final class Reachability implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-UNREACHABLE",
                "No run comes there: what is drawn there is never done.",
                "Draw an edge that leads there, or delete it."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        if (plan.plan().startPlace().isEmpty()) {
            return;
        }
        Set<String> dead = new LinkedHashSet<>();
        plan.plan().places().forEach(p -> dead.add(p.id()));
        plan.plan().transitions().forEach(t -> dead.add(t.id()));
        dead.removeAll(from(plan));
        while (!dead.isEmpty()) {
            Set<String> part = connected(plan, dead);
            dead.removeAll(part);
            boolean saidElsewhere = part.stream()
                    .flatMap(id -> plan.transition(id).stream())
                    .anyMatch(t -> plan.inEdges(t).isEmpty());
            if (!saidElsewhere) { // what begins with a transition that never fires
                report(plan, part, report);
            }
        }
    }

    /** The vertices of some that hang together with the first of them. */
    private static Set<String> connected(PlanContext plan, Set<String> some) {
        Set<String> part = new LinkedHashSet<>();
        Deque<String> open = new ArrayDeque<>(List.of(some.iterator().next()));
        while (!open.isEmpty()) {
            String vertex = open.pop();
            if (some.contains(vertex) && part.add(vertex)) {
                open.addAll(next(plan, vertex));
                plan.transition(vertex).ifPresent(t -> plan.inPlaces(t).forEach(p -> open.add(p.id())));
                plan.place(vertex).ifPresent(p -> plan.edgesInto(p).forEach(e -> open.add(e.transition())));
            }
        }
        return part;
    }

    /** Says of a part of the net once that nothing leads to it, at a vertex with nothing before it where there is one. */
    private static void report(PlanContext plan, Set<String> part, Consumer<Finding> report) {
        String first = part.stream()
                .filter(id ->
                        plan.place(id).filter(p -> plan.edgesInto(p).isEmpty()).isPresent())
                .findFirst()
                .orElseGet(() -> part.iterator().next());
        String name = plan.place(first)
                .map(plan::name)
                .orElseGet(() -> plan.transition(first).map(plan::name).orElseThrow());
        String pointer = plan.place(first)
                .map(plan::at)
                .orElseGet(() -> plan.transition(first).map(plan::at).orElseThrow());
        Set<String> elements = new LinkedHashSet<>(List.of(first));
        elements.addAll(part);
        int more = part.size() - 1;
        report.accept(Finding.warning(
                "W-UNREACHABLE",
                pointer,
                "Nothing leads to the " + name
                        + (more == 0
                                ? ""
                                : ", nor to the "
                                        + (more == 1 ? "place or transition" : more + " places and transitions")
                                        + " connected with it"),
                elements.toArray(String[]::new)));
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
