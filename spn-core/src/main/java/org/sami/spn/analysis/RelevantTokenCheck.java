package org.sami.spn.analysis;

import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.TokenNeed;

/** Relevant tokens are those that an input event names: without such an event there are none (thesis 3.1, 9.3.4). */
final class RelevantTokenCheck implements PlanCheck {
    private static final Set<EventRole> MAY_NAME = Set.of(
            EventRole.INTERRUPT,
            EventRole.GENERAL_INTERRUPT_RECEIVED,
            EventRole.PROXY_INTERRUPT_RECEIVED,
            EventRole.SUB_MISSION_ABORTED);

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            boolean names = plan.inputsOf(t).stream().anyMatch(RelevantTokenCheck::mayName);
            if (names || t.inputs().size() > plan.inputsOf(t).size()) {
                continue;
            }
            for (InEdge e : plan.inEdges(t)) {
                if (e.requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT)) {
                    report(t, plan.at(e), e.id(), report);
                }
            }
            for (OutEdge e : plan.outEdges(t)) {
                if (e.requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT)) {
                    report(t, plan.at(e), e.id(), report);
                }
            }
        }
    }

    private static boolean mayName(PlacedInput input) {
        return input.type().tokens() != TokenNeed.NONE
                || MAY_NAME.contains(input.type().role());
    }

    private static void report(Transition t, String pointer, String edge, Consumer<Finding> report) {
        report.accept(
                t.inputs().isEmpty()
                        ? Finding.error(
                                "E-RELEVANT-WITHOUT-EVENT",
                                pointer,
                                "An edge of the " + PlanContext.name(t)
                                        + " speaks of relevant tokens, but the transition has no input event to name them",
                                edge,
                                t.id())
                        : Finding.warning(
                                "W-RELEVANT-NOBODY",
                                pointer,
                                "An edge of the " + PlanContext.name(t)
                                        + " speaks of relevant tokens, but its input events name nobody",
                                edge,
                                t.id()));
    }
}
