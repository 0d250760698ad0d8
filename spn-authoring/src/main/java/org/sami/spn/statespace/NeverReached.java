package org.sami.spn.statespace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * Finds places that nobody ever enters and transitions that never fire, whatever robots, services and operator do. Where not all states
 * could be looked at it is a note.
 */
final class NeverReached implements SpaceQuestion {
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
        return "Looks for places that are never entered and transitions that never fire, whatever is answered. Values"
                + " are samples, so a way that depends on a value may be missed.";
    }

    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        NEVER,
                        "All runs were looked at and none comes there: what is drawn there is never done.",
                        "Look at the requirements on the ways there; correct the one that is never met, or delete "
                                + "what is not needed."),
                new Advice(
                        NOT_YET,
                        "No run was found that comes there, but not all were looked at: it may still be reached.",
                        "Look at more states (--states) or with another number of robots (--boats); or play a run "
                                + "there by hand."));
    }

    @Override
    public List<DeepFinding> findings(Exploration found, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        if (SearchWords.isSubMission(request)) {
            return List.of();
        }
        if (found.nodes().get(0).isOver()) {
            return List.of(endsAtOnce(request, plan, found));
        }
        Set<String> untried = new UntriedTransitions(plan, request.vocabulary(), found.fired()).andBehindThem();
        List<DeepFinding> findings = new ArrayList<>();
        for (int i = 0; i < plan.places().size(); i++) {
            Place place = plan.places().get(i);
            if (!found.visited().contains(place.id()) && !untried.contains(place.id()) && !onlyConsumes(plan, place)) {
                findings.add(finding(request, plan, found, "/places/" + i, place.id(), words(request, place)));
            }
        }
        for (int i = 0; i < plan.transitions().size(); i++) {
            Transition transition = plan.transitions().get(i);
            if (!found.fired().contains(transition.id()) && !untried.contains(transition.id())) {
                findings.add(finding(
                        request, plan, found, "/transitions/" + i, transition.id(), words(request, transition)));
            }
        }
        return findings;
    }

    @Override
    public String result(Exploration found, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        List<String> untried = new UntriedTransitions(plan, request.vocabulary(), found.fired()).words(request);
        return words(plan.places().size(), found.visited(), "places") + ", "
                + words(plan.transitions().size(), found.fired(), "transitions")
                + (untried.isEmpty() ? "" : " (not tried: " + String.join(", ", untried) + ")");
    }

    private static DeepFinding endsAtOnce(DeepRequest request, Plan plan, Exploration found) {
        String message =
                "The plan \"" + plan.title() + "\" ends as it starts (" + SearchWords.robots(request) + "): only "
                        + found.visited().size() + " of its " + plan.places().size() + " places are reached";
        Finding finding = Finding.warning(NEVER, SearchWords.pointer(request, plan), message);
        return new DeepFinding(finding.inPlan(plan.id()), Optional.empty());
    }

    /** Whether all edges into a place consume: it is drawn for them to end somewhere, and nobody is to enter. */
    private static boolean onlyConsumes(Plan plan, Place place) {
        List<OutEdge> into = plan.outEdges().stream()
                .filter(edge -> edge.place().equals(place.id()))
                .toList();
        return !into.isEmpty()
                && into.stream()
                        .allMatch(edge -> !edge.requirements().isEmpty()
                                && edge.requirements().stream().allMatch(moved -> moved.action() == Action.CONSUME));
    }

    private static String words(int all, Set<String> reached, String what) {
        return reached.size() + " of " + all + " " + what + " reached";
    }

    private static String words(DeepRequest request, Place place) {
        return "Nothing enters the " + SearchWords.names(request).withKind(place);
    }

    private static String words(DeepRequest request, Transition transition) {
        return "The " + SearchWords.names(request).withKind(transition) + " never fires";
    }

    private static DeepFinding finding(
            DeepRequest request, Plan plan, Exploration found, String at, String element, String words) {
        String how = found.isComplete()
                ? ", whatever is answered (" + SearchWords.robots(request) + "): look at the requirements before it"
                : " in the first " + found.looked() + " states (" + SearchWords.robots(request) + "): look further";
        Finding finding = new Finding(
                found.isComplete() ? Severity.WARNING : Severity.NOTE,
                found.isComplete() ? NEVER : NOT_YET,
                SearchWords.pointer(request, plan) + at,
                words + how,
                List.of(element));
        return new DeepFinding(finding.inPlan(plan.id()), Optional.empty());
    }
}
