package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.vocabulary.EventRole;

/** Tasks are not led back to before the place that makes them: it would make them once more. */
final class TasksMadeAgain implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-TASKS-MADE-AGAIN",
                "Whenever a task is led back all tasks are made once more: there are more and more of them.",
                "Lead the tasks to a place after the one that makes them."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            if (output.type().role() == EventRole.GENERATE_TASKS
                    && plan.plan().tasks().isEmpty()
                    && plan.parents().isEmpty()) {
                Set<String> before = before(plan, output.place());
                for (OutEdge edge : plan.plan().outEdges()) {
                    if (before.contains(edge.place())
                            && plan.flow().along(edge).contains(TokenType.TASK)
                            && !comesFrom(plan, edge, before)) {
                        report(plan, output, edge, report);
                    }
                }
            }
        }
    }

    /** The place and those to which a way leads from the start without it. */
    private static Set<String> before(PlanContext plan, Place making) {
        Set<String> before = new HashSet<>(Set.of(making.id()));
        Deque<Place> open = new ArrayDeque<>();
        plan.plan().startPlace().ifPresent(open::push);
        while (!open.isEmpty()) {
            Place place = open.pop();
            if (before.add(place.id())) {
                plan.outTransitions(place).forEach(t -> plan.outPlaces(t).forEach(open::push));
            }
        }
        return before;
    }

    private static boolean comesFrom(PlanContext plan, OutEdge edge, Set<String> before) {
        return plan.transition(edge.transition()).map(plan::inPlaces).orElse(List.<Place>of()).stream()
                .anyMatch(p -> before.contains(p.id()));
    }

    private static void report(PlanContext plan, PlacedOutput output, OutEdge edge, Consumer<Finding> report) {
        report.accept(Finding.warning(
                "W-TASKS-MADE-AGAIN",
                plan.at(edge),
                plan.transitionName(edge.transition()) + " leads tasks back to the " + plan.placeName(edge.place())
                        + ", from where " + plan.name(output)
                        + " makes tasks once more: lead them to a place after it",
                edge.id(),
                edge.transition()));
    }
}
