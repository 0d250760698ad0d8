package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** What is taken or consumed comes from the places before the transition (thesis 4.1.3); without any there is nothing. */
final class EmptyPools implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-EMPTY-POOL",
                "There is nobody to take: the place behind the edge stays empty.",
                "Let the edge add tokens, or draw a place with tokens before the transition."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            if (!plan.inEdges(t).isEmpty()) {
                continue;
            }
            for (OutEdge e : plan.outEdges(t)) {
                boolean removes = e.requirements().stream()
                        .anyMatch(r -> r.kind() != TokenKind.UNCONDITIONAL && r.action() != Action.ADD);
                if (removes) {
                    Finding finding = Finding.warning(
                            "W-EMPTY-POOL",
                            plan.at(e),
                            "The " + plan.name(t) + " has no place before it to take tokens from",
                            e.id(),
                            t.id());
                    report.accept(
                            e.requirements().stream().allMatch(EmptyPools::canAdd)
                                    ? finding.fixedBy(
                                            "Add them instead",
                                            new EdgeEdit.SetOutRequirements(
                                                    plan.plan().id(), e.id(), adding(e)))
                                    : finding);
                }
            }
        }
    }

    /** Whether a requirement means something to a transition without places before it, if it adds. */
    private static boolean canAdd(OutRequirement r) {
        boolean adds = r.kind() == TokenKind.RELEVANT || (r.kind() == TokenKind.GENERIC && !r.takesAll());
        return r.kind() == TokenKind.UNCONDITIONAL || (adds && r.action() != Action.CONSUME);
    }

    private static List<OutRequirement> adding(OutEdge e) {
        return e.requirements().stream()
                .map(r -> r.kind() == TokenKind.UNCONDITIONAL ? r : OutRequirement.of(Action.ADD, r.n(), r.kind()))
                .toList();
    }
}
