package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;

/** A plan can reach an end, and nothing follows an end (thesis 4.3.3, Start and End Places). */
final class EndPlaces implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "W-NO-END",
                        "The mission never ends by itself: the operator has to abort it.",
                        "Mark the place where the work is done as the end."),
                new Advice(
                        "W-END-UNREACHABLE",
                        "No run comes to the end: the mission never ends by itself.",
                        "Draw the edges that lead to the end place, or mark another place as the end."),
                new Advice(
                        "E-END-GOES-ON",
                        "The mission is over when a token comes to the end: the transition behind it never fires.",
                        "Delete the edge to that transition, or do not mark the place as the end."),
                new Advice(
                        "W-ENDS-NOTHING",
                        "Only an end place ends the shared instance: the mark has no effect.",
                        "Mark the place as an end too, or take the mark away."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        List<Place> ends = plan.plan().places().stream().filter(Place::end).toList();
        Set<String> reached = Reachability.from(plan);
        if (ends.isEmpty()) {
            report.accept(Finding.warning(
                    "W-NO-END",
                    plan.pointer(),
                    "The plan \"" + plan.plan().title()
                            + "\" has no end place: it runs until it is aborted or completed",
                    plan.plan().id()));
        } else if (ends.stream().noneMatch(p -> reached.contains(p.id()))) {
            report.accept(Finding.warning(
                    "W-END-UNREACHABLE",
                    plan.pointer(),
                    "No end place of the plan \"" + plan.plan().title() + "\" can be reached from its start",
                    ends.stream().map(Place::id).toArray(String[]::new)));
        }
        for (Place place : plan.plan().places()) {
            if (place.endsSharedInstance() && !place.end()) {
                report.accept(Finding.warning(
                                "W-ENDS-NOTHING",
                                plan.at(place),
                                "The " + plan.name(place) + " ends the shared instance, but is no end place",
                                place.id())
                        .fixedBy(
                                "Do not end the shared instance there",
                                new VertexEdit.SetEnd(plan.plan().id(), place.id(), false, false)));
            }
        }
        for (Place end : ends) {
            if (!plan.outTransitions(end).isEmpty()) {
                report.accept(Finding.error(
                                "E-END-GOES-ON",
                                plan.at(end),
                                "The end " + plan.name(end)
                                        + " has a transition after it: nothing happens after an end",
                                end.id(),
                                plan.outTransitions(end).get(0).id())
                        .fixedBy(
                                "Do not end there",
                                new VertexEdit.SetEnd(plan.plan().id(), end.id(), false, false)));
            }
        }
    }
}
