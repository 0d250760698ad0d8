package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;

/** A plan has exactly one start place, which is no end place (thesis 3.1, 4.3.3 Start and End Places). */
final class StartPlace implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "E-NO-START",
                        "Nobody knows where the mission begins: it cannot be started.",
                        "Mark the first place as the start."),
                new Advice(
                        "E-TWO-STARTS",
                        "A mission begins in one place: with two nobody knows where.",
                        "Keep one start, and lead from it to the other."),
                new Advice(
                        "E-START-IS-END",
                        "The mission would be over as it begins.",
                        "Take one of the two marks away."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        List<Place> starts = plan.plan().places().stream().filter(Place::start).toList();
        if (starts.isEmpty()) {
            Finding finding = Finding.error(
                    "E-NO-START",
                    plan.pointer(),
                    "The plan \"" + plan.plan().title() + "\" has no start place",
                    plan.plan().id());
            report.accept(beginning(plan)
                    .map(place -> finding.fixedBy(
                            "Start at the " + plan.name(place),
                            new VertexEdit.SetStart(plan.plan().id(), place.id())))
                    .orElse(finding));
        }
        for (Place place : starts.subList(Math.min(1, starts.size()), starts.size())) {
            report.accept(Finding.error(
                            "E-TWO-STARTS",
                            plan.at(place),
                            "A second start: " + plan.name(place) + " in addition to " + plan.name(starts.get(0)),
                            starts.get(0).id(),
                            place.id())
                    .fixedBy(
                            "Start at the " + plan.name(starts.get(0)) + " alone",
                            new VertexEdit.SetStart(
                                    plan.plan().id(), starts.get(0).id())));
        }
        starts.stream()
                .filter(Place::end)
                .forEach(place -> report.accept(Finding.error(
                                "E-START-IS-END",
                                plan.at(place),
                                "The start " + plan.name(place) + " is also an end",
                                place.id())
                        .fixedBy(
                                "Do not end there",
                                new VertexEdit.SetEnd(plan.plan().id(), place.id(), false, false))));
    }

    /** The only place to which nothing leads and from which something goes on. */
    private static Optional<Place> beginning(PlanContext plan) {
        List<Place> first = plan.plan().places().stream()
                .filter(p ->
                        plan.edgesInto(p).isEmpty() && !plan.outTransitions(p).isEmpty() && !p.end())
                .toList();
        return first.size() == 1 ? Optional.of(first.get(0)) : Optional.empty();
    }
}
