package org.sami.spn.statespace;

import java.util.List;
import java.util.Optional;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;

/** Finds boats, and tasks, that a mission leaves somewhere when it ends with others of them. */
final class LeftAtTheEnd implements SpaceQuestion {
    static final String EARLY = "W-ENDS-EARLY";
    static final String LEFT_OUT = "W-LEFT-OUT";
    static final String FORGOTTEN = "W-FORGOTTEN";

    @Override
    public String id() {
        return "left-at-the-end";
    }

    @Override
    public String title() {
        return "Left at the end";
    }

    @Override
    public String help() {
        return "Looks for ends of the mission that come with the first of many, or leave a robot or a task behind"
                + " somewhere. An end by a button of the operator is as he wants it.";
    }

    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        EARLY,
                        "The mission is over while somebody is still at work: what that one does is no longer "
                                + "watched.",
                        "Let the transition before the end also ask for none (= 0) in the places where somebody may "
                                + "be at work."),
                new Advice(
                        LEFT_OUT,
                        "The transition that ends the mission takes some and leaves others in the place.",
                        "Let its edge take all."),
                new Advice(
                        FORGOTTEN,
                        "Somebody stands in a place that the end does not look at: nobody sends that one home.",
                        "Let the transition before the end take them too, or lead them to where it does."));
    }

    @Override
    public List<DeepFinding> findings(Exploration found, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        if (SearchWords.isSubMission(request)) {
            return List.of();
        }
        return found.ends().all().entrySet().stream()
                .map(end -> finding(request, plan, end.getKey(), end.getValue()))
                .toList();
    }

    private static DeepFinding finding(DeepRequest request, Plan plan, EndsOfRuns.Left left, EndsOfRuns.Seen seen) {
        String ends = "The plan \"" + plan.title() + "\" ends by " + SearchWords.transition(request, left.transition());
        String who = SearchWords.tokens(seen.left());
        String where = SearchWords.place(request, left.place());
        String message = switch (left.why()) {
            case UNDER_WAY ->
                ends + " with " + SearchWords.tokens(seen.atEnd()) + " while " + who
                        + " is still under way in " + where
                        + SearchWords.when(request, seen.from().steps() + 1)
                        + ": require that nobody is left there";
            case NOT_TAKEN ->
                ends + ", which leaves " + who + " out in " + where
                        + SearchWords.when(request, seen.from().steps() + 1)
                        + ": take all who stand there";
            case FORGOTTEN ->
                ends + ", which forgets " + who + " in " + where
                        + SearchWords.when(request, seen.from().steps() + 1)
                        + ": lead from there to the end, or require that nobody is left there";
        };
        String code = switch (left.why()) {
            case UNDER_WAY -> EARLY;
            case NOT_TAKEN -> LEFT_OUT;
            case FORGOTTEN -> FORGOTTEN;
        };
        Finding finding = Finding.warning(
                        code, SearchWords.pointer(request, plan), message, left.place(), left.transition())
                .inPlan(plan.id());
        String name = "ends and leaves somebody in " + where;
        return new DeepFinding(finding, Optional.of(seen.from().witness(name, request.robots(), seen.last())));
    }

    @Override
    public String result(Exploration found, DeepRequest request) {
        if (SearchWords.isSubMission(request)) {
            return "as a sub-mission it ends for each who enters";
        }
        int count = found.ends().all().size();
        return count == 0
                ? "no end leaves anybody behind"
                : count + (count == 1 ? " end leaves" : " ends leave") + " somebody behind";
    }
}
