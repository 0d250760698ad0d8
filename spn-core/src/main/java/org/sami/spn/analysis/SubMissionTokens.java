package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** Sub-mission tokens come from a sub-mission on a place before the transition (R-SUB-4). */
final class SubMissionTokens implements PlanCheck {
    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            boolean hasSubMission =
                    plan.inPlaces(t).stream().anyMatch(p -> !p.subMissions().isEmpty());
            for (OutEdge e : plan.outEdges(t)) {
                if (!hasSubMission
                        && e.requirements().stream().anyMatch(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS)) {
                    report.accept(Finding.error(
                                    "E-NO-SUB-MISSION",
                                    plan.at(e),
                                    "The " + PlanContext.name(t)
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
