package org.sami.spn.analysis;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/**
 * The parts of a plan that can never run: one finding says that nothing leads there, and not one more for each event what would be
 * wrong if it ran.
 */
final class PartsThatNeverRun {
    private final Set<String> dead = new HashSet<>();
    private final Set<String> alive = new HashSet<>();
    private final boolean started;

    PartsThatNeverRun(PlanContext plan) {
        started = plan.plan().startPlace().isPresent();
        Set<String> reached = started ? Reachability.from(plan) : Set.of();
        for (Place place : plan.plan().places()) {
            Set<String> ids = reached.contains(place.id()) ? alive : dead;
            ids.add(place.id());
            place.outputs().forEach(o -> ids.add(o.id()));
            place.subMissions().forEach(s -> ids.add(s.id()));
        }
        for (Transition t : plan.plan().transitions()) {
            Set<String> ids = reached.contains(t.id()) ? alive : dead;
            ids.add(t.id());
            t.inputs().forEach(i -> ids.add(i.id()));
        }
        for (InEdge edge : plan.plan().inEdges()) {
            (reached.contains(edge.place()) ? alive : dead).add(edge.id());
        }
        for (OutEdge edge : plan.plan().outEdges()) {
            (reached.contains(edge.transition()) ? alive : dead).add(edge.id());
        }
    }

    /** The findings but those about nothing else than what never runs. */
    List<Finding> without(List<Finding> findings) {
        return dead.isEmpty()
                ? findings
                : findings.stream().filter(f -> !isNoise(f)).toList();
    }

    private boolean isNoise(Finding finding) {
        return (started || !finding.isError()) // that a start is lacking keeps the plan from running, and is mended at
                // once
                && finding.elements().stream().anyMatch(dead::contains)
                && finding.elements().stream().noneMatch(alive::contains);
    }
}
