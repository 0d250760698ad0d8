package org.sami.spn.statespace;

import java.util.List;
import java.util.Optional;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;

/** Finds places that are drawn for waiting and in which nobody ever waits for the others. */
final class WaitsForNobody implements SpaceQuestion {
    static final String CODE = "W-WAITS-FOR-NOBODY";

    @Override
    public String id() {
        return "waits-for-nobody";
    }

    @Override
    public String title() {
        return "Waits for nobody";
    }

    @Override
    public String help() {
        return "Looks for places in which nothing is asked and nobody ever waits: the first who comes goes on, while"
                + " others are on their way.";
    }

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                CODE,
                "The place is drawn so that they go on together, and the first goes on alone.",
                "Let the transition also ask for none (= 0) in the places from which the others come; else "
                        + "delete the place."));
    }

    @Override
    public List<DeepFinding> findings(Exploration found, DeepRequest request) {
        Plan plan = request.project().plan(request.plan()).orElseThrow();
        return found.firsts().all(found.isComplete()).entrySet().stream()
                .map(gate -> finding(request, plan, gate.getKey(), gate.getValue()))
                .toList();
    }

    private static DeepFinding finding(DeepRequest request, Plan plan, FirstOfMany.Gate gate, FirstOfMany.Seen seen) {
        String place = SearchWords.place(request, gate.place());
        String message = "Nobody ever waits in " + place + ": " + SearchWords.transition(request, gate.transition())
                + " takes " + SearchWords.tokens(seen.went()) + " on while " + SearchWords.token(seen.other())
                + " is still in " + SearchWords.place(request, seen.otherPlace())
                + SearchWords.when(request, seen.from().steps() + 1)
                + ". Where all are to go on together, require that nobody is left there; else the place can go";
        Finding finding = Finding.warning(
                        CODE, SearchWords.pointer(request, plan), message, gate.place(), gate.transition())
                .inPlan(plan.id());
        return new DeepFinding(
                finding, Optional.of(seen.from().witness("does not wait in " + place, request.robots(), seen.last())));
    }

    @Override
    public String result(Exploration found, DeepRequest request) {
        int count = found.firsts().all(found.isComplete()).size();
        return count == 0
                ? "who is to wait waits"
                : "nobody waits in " + count + (count == 1 ? " place" : " places") + " made for it";
    }
}
