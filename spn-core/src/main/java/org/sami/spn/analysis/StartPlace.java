package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;

/** A plan has exactly one start place, which is no end place (thesis 3.1, 4.3.3 Start and End Places). */
final class StartPlace implements PlanCheck {
    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        List<Place> starts = plan.plan().places().stream().filter(Place::start).toList();
        if (starts.isEmpty()) {
            report.accept(Finding.error(
                    "E-NO-START",
                    plan.pointer(),
                    "The plan \"" + plan.plan().id() + "\" has no start place",
                    plan.plan().id()));
        }
        for (Place place : starts.subList(Math.min(1, starts.size()), starts.size())) {
            report.accept(Finding.error(
                    "E-TWO-STARTS",
                    plan.at(place),
                    "A second start: " + PlanContext.name(place) + " beside " + PlanContext.name(starts.get(0)),
                    starts.get(0).id(),
                    place.id()));
        }
        starts.stream()
                .filter(Place::end)
                .forEach(place -> report.accept(Finding.error(
                        "E-START-IS-END",
                        plan.at(place),
                        "The start " + PlanContext.name(place) + " is also an end",
                        place.id())));
    }
}
