package org.sami.spn.analysis.space;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * Finds places that nobody ever enters and transitions that never fire, whatever robots, services and operator do. Where not all states
 * could be looked at it is a note.
 */
final class NeverReached implements DeepCheck {
    static final String NEVER = "W-NEVER-REACHED";
    static final String NOT_YET = "N-NOT-REACHED";

    @Override
    public String id() {
        return "never-reached";
    }

    @Override
    public String title() {
        return "Out of reach";
    }

    @Override
    public String help() {
        return "Looks for places that are never entered and transitions that never fire, whatever is answered. Values are samples, so a way that"
                + " depends on a value may be missed.";
    }

    @Override
    public DeepResult run(DeepRequest request, SearchWatch watch) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        Exploration found = Exploration.of(request, watch);
        List<DeepFinding> findings = new ArrayList<>();
        for (int i = 0; i < plan.places().size(); i++) {
            Place place = plan.places().get(i);
            if (!found.visited().contains(place.id())) {
                findings.add(finding(request, plan, found, "/places/" + i, place.id(), words(place)));
            }
        }
        for (int i = 0; i < plan.transitions().size(); i++) {
            Transition transition = plan.transitions().get(i);
            if (!found.fired().contains(transition.id())) {
                findings.add(finding(request, plan, found, "/transitions/" + i, transition.id(), words(transition)));
            }
        }
        String looked = found.looked() + " states with " + StuckStates.robots(request);
        String summary = (found.isComplete() ? "All " + looked + " were looked at: " : "Of the first " + looked + ": ")
                + words(plan.places().size(), found.visited(), "places") + ", "
                + words(plan.transitions().size(), found.fired(), "transitions")
                + (found.isComplete() ? "" : "; there are more that were not looked at");
        return new DeepResult(findings, found.looked(), found.isComplete(), summary);
    }

    private static String words(int all, Set<String> reached, String what) {
        return reached.size() + " of " + all + " " + what + " reached";
    }

    private static String words(Place place) {
        return "Nothing enters the place \"" + (place.name().isEmpty() ? place.id() : place.name()) + "\"";
    }

    private static String words(Transition transition) {
        return "The transition \"" + (transition.name().isEmpty() ? transition.id() : transition.name())
                + "\" never fires";
    }

    private static DeepFinding finding(
            DeepRequest request, Plan plan, Exploration found, String at, String element, String words) {
        String how = found.isComplete()
                ? ", whatever is answered (" + StuckStates.robots(request) + "): look at the requirements before it"
                : " in the first " + found.looked() + " states (" + StuckStates.robots(request) + "): look further";
        Finding finding = new Finding(
                found.isComplete() ? Severity.WARNING : Severity.NOTE,
                found.isComplete() ? NEVER : NOT_YET,
                StuckStates.pointer(request, plan) + at,
                words + how,
                List.of(element));
        return new DeepFinding(finding.inPlan(plan.id()), Optional.empty());
    }
}
