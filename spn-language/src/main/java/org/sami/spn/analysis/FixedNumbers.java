package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.EventRole;

/**
 * A transition asks for a number of robots or tasks, though how many there are shows only when the mission runs, and nothing else is
 * drawn for another number.
 */
final class FixedNumbers implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-FIXED-NUMBER",
                "How many there are shows only in the run; with any other number the transition never fires "
                        + "and the mission hangs.",
                "Ask for at least 1 here and for none (= 0) in the places before, or draw what happens with "
                        + "another number."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (InEdge edge : plan.plan().inEdges()) {
            for (InRequirement r : edge.requirements()) {
                if (isFixed(r) && varies(plan, r.kind()) && !TooManyRequired.isTooMany(plan, r)) {
                    plan.place(edge.place())
                            .filter(place -> !hasOther(plan, place, edge, r))
                            .ifPresent(place -> report(plan, place, edge, r, report));
                }
            }
        }
    }

    private static boolean isFixed(InRequirement r) {
        return (r.match() == Match.EXACTLY && r.n() >= 1) || (r.match() == Match.AT_LEAST && r.n() >= 2);
    }

    private static boolean varies(PlanContext plan, TokenKind kind) {
        return switch (kind) {
            case ANY_PROXY -> true;
            case ANY_TASK ->
                !plan.parents().isEmpty()
                        || plan.outputs().stream().anyMatch(o -> o.type().role() == EventRole.GENERATE_TASKS);
            default -> false;
        };
    }

    /** Whether another transition after the place fires with another number. */
    private static boolean hasOther(PlanContext plan, Place place, InEdge edge, InRequirement r) {
        return plan.plan().inEdges().stream()
                .filter(other ->
                        other.place().equals(place.id()) && !other.transition().equals(edge.transition()))
                .flatMap(other -> other.requirements().stream())
                .anyMatch(other -> other.kind() == r.kind() && !other.equals(r) && wantsSome(other));
    }

    /** Whether a requirement is met by some tokens, and not only where there are none. */
    private static boolean wantsSome(InRequirement r) {
        return !r.asksForNone() && r.n() > 0;
    }

    private static void report(PlanContext plan, Place place, InEdge edge, InRequirement r, Consumer<Finding> report) {
        String what = r.kind() == TokenKind.ANY_TASK ? "tasks" : "robots";
        String wanted = (r.match() == Match.EXACTLY ? "exactly " : "at least ") + r.n();
        report.accept(Finding.warning(
                        "W-FIXED-NUMBER",
                        plan.at(edge),
                        plan.transitionName(edge.transition()) + " waits for " + wanted + " " + what + " in the "
                                + plan.name(place) + ", but how many there are shows only when the mission runs:"
                                + " with another number it never fires. Ask for at least 1 here and for none in the"
                                + " places before, or draw what happens with another number",
                        edge.id(),
                        edge.transition())
                .fixedBy(
                        "Ask for at least 1",
                        new EdgeEdit.SetInRequirements(
                                plan.plan().id(),
                                edge.id(),
                                edge.requirements().stream()
                                        .map(o -> o.equals(r) ? InRequirement.of(r.kind(), Match.AT_LEAST, 1) : o)
                                        .distinct()
                                        .toList())));
    }
}
