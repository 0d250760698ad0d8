package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * Every edge has a requirement; one that wants none says unconditional (thesis 4.3.3, Token Requirements).
 *
 * <p>Implements R-OUT-8.
 */
final class EdgesWithoutRequirement implements PlanCheck {
    private static final String CODE = "E-NO-REQUIREMENT";

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                CODE,
                "Without a requirement nobody knows which tokens the edge waits for or moves.",
                "Give the edge a requirement; if it wants none, let it say \"unconditional\"."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (InEdge e : plan.plan().inEdges()) {
            if (e.requirements().isEmpty()) {
                report.accept(Finding.error(CODE, plan.at(e), "The " + plan.name(e) + " has no requirement", e.id())
                        .fixedBy(
                                "Ask for at least 1 generic token",
                                in(plan, e, InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1)))
                        .fixedBy("Ask for nothing", in(plan, e, InRequirement.unconditional())));
            }
        }
        for (OutEdge e : plan.plan().outEdges()) {
            if (e.requirements().isEmpty()) {
                report.accept(taking(
                        plan,
                        e,
                        Finding.error(CODE, plan.at(e), "The " + plan.name(e) + " has no requirement", e.id())));
            }
        }
    }

    private static Edit in(PlanContext plan, InEdge e, InRequirement requirement) {
        return new EdgeEdit.SetInRequirements(plan.plan().id(), e.id(), List.of(requirement));
    }

    /** Takes the tokens that the place needs: those that the transition's input events name, all, or any. */
    private static Finding taking(PlanContext plan, OutEdge e, Finding finding) {
        boolean needsTokens = plan.outputs().stream()
                .filter(o -> o.place().id().equals(e.place()))
                .anyMatch(o -> o.type().tokens() != TokenNeed.NONE);
        boolean named = plan.transition(e.transition()).map(plan::inputsOf).orElse(List.of()).stream()
                .anyMatch(i -> i.type().tokens() != TokenNeed.NONE);
        Finding fixed = named
                ? finding.fixedBy(
                        "Take the tokens that the event names", out(plan, e, OutRequirement.ALL, TokenKind.RELEVANT))
                : needsTokens
                        ? finding.fixedBy("Take all tokens", out(plan, e, OutRequirement.ALL, TokenKind.ANY_TOKEN))
                        : finding.fixedBy("Take 1 generic token", out(plan, e, 1, TokenKind.GENERIC));
        return fixed.fixedBy(
                "Enter with nobody",
                new EdgeEdit.SetOutRequirements(plan.plan().id(), e.id(), List.of(OutRequirement.unconditional())));
    }

    private static Edit out(PlanContext plan, OutEdge e, int n, TokenKind kind) {
        return new EdgeEdit.SetOutRequirements(
                plan.plan().id(), e.id(), List.of(OutRequirement.of(Action.TAKE, n, kind)));
    }
}
