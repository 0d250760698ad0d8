package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;

/**
 * Who moves the tokens of a sub-mission, or waits for what one reports, has one on a place before the transition (R-SUB-4, appendix .2.2).
 */
final class MissingSubMissions implements PlanCheck {
    private static final String NO_SUB_MISSION = "E-NO-SUB-MISSION";

    /** What a sub-mission reports to the transitions after its place. */
    static final Set<EventRole> REPORTED = Set.of(EventRole.CHECK_RETURN, EventRole.SUB_MISSION_ABORTED);

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                NO_SUB_MISSION,
                "There is no such sub-mission: the transition waits for what never comes.",
                "Put the sub-mission on the place, or correct the name."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        events(plan, report);
        tokens(plan, report);
    }

    private static void events(PlanContext plan, Consumer<Finding> report) {
        for (PlacedInput input : plan.inputs()) {
            Transition t = input.transition();
            boolean runsOne = plan.inPlaces(t).stream()
                    .flatMap(p -> p.subMissions().stream())
                    .anyMatch(s -> plan.child(s).isPresent());
            if (REPORTED.contains(input.type().role()) && !runsOne) {
                report.accept(Fixes.removing(
                        plan,
                        input,
                        Finding.error(
                                NO_SUB_MISSION,
                                input.pointer(),
                                "The " + plan.name(t) + " waits for "
                                        + input.type().title() + ", but no place before it has a sub-mission",
                                t.id(),
                                input.spec().id())));
            }
        }
    }

    private static void tokens(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            boolean hasSubMission =
                    plan.inPlaces(t).stream().anyMatch(p -> !p.subMissions().isEmpty());
            for (OutEdge e : plan.outEdges(t)) {
                if (!hasSubMission
                        && e.requirements().stream().anyMatch(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS)) {
                    report.accept(Finding.error(
                                    NO_SUB_MISSION,
                                    plan.at(e),
                                    "The " + plan.name(t)
                                            + " moves sub-mission tokens, but no place before it has a sub-mission",
                                    e.id(),
                                    t.id())
                            .fixedBy(
                                    "Move any tokens instead",
                                    new EdgeEdit.SetOutRequirements(plan.plan().id(), e.id(), withAnyTokens(e))));
                }
            }
        }
    }

    private static List<OutRequirement> withAnyTokens(OutEdge e) {
        return e.requirements().stream()
                .map(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS
                        ? OutRequirement.of(r.action(), r.n(), TokenKind.ANY_TOKEN)
                        : r)
                .toList();
    }
}
