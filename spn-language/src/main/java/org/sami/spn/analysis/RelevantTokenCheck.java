package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.NamedTokens;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** Relevant tokens are those that an input event names: without such an event there are none (thesis 3.1, 9.3.4). */
final class RelevantTokenCheck implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "E-RELEVANT-WITHOUT-EVENT",
                        "Relevant tokens are those whom an input event names, and the transition has none: the edge "
                                + "moves nobody.",
                        "Speak of robots or tasks in the requirement, or give the transition an input event."),
                new Advice(
                        "W-RELEVANT-NOBODY",
                        "The input events of the transition name nobody, so there are no relevant tokens: the edge "
                                + "moves nobody.",
                        "Speak of robots or tasks in the requirement, or wait for an event that names them."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            boolean names = plan.inputsOf(t).stream()
                    .anyMatch(input -> !NamedTokens.of(input.type()).isEmpty());
            if (names || t.inputs().size() > plan.inputsOf(t).size()) {
                continue;
            }
            for (InEdge e : plan.inEdges(t)) {
                if (e.requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT)) {
                    String edge = "The " + plan.name(e) + " asks for";
                    report(t, plan.at(e), e.id(), edge, finding -> report.accept(askingFor(plan, e, finding)));
                }
            }
            for (OutEdge e : plan.outEdges(t)) {
                if (e.requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT)) {
                    String edge = "The " + plan.name(e) + " moves";
                    report(t, plan.at(e), e.id(), edge, finding -> report.accept(moving(plan, t, e, finding)));
                }
            }
        }
    }

    /** Offers to ask for robots or tasks, as they may stand in the edge's place, in the stead of relevant tokens. */
    private static Finding askingFor(PlanContext plan, InEdge e, Finding finding) {
        Finding fixed = finding;
        for (TokenKind kind : kinds(plan.place(e.place()).map(plan.flow()::at).orElse(Set.of()))) {
            fixed = fixed.fixedBy(
                    "Ask for " + (kind == TokenKind.ANY_TASK ? "tasks" : "robots"),
                    new EdgeEdit.SetInRequirements(
                            plan.plan().id(),
                            e.id(),
                            e.requirements().stream()
                                    .map(r -> r.kind() == TokenKind.RELEVANT ? in(r, kind) : r)
                                    .distinct()
                                    .toList()));
        }
        return fixed;
    }

    private static InRequirement in(InRequirement r, TokenKind kind) {
        return r.match() == Match.ALL
                ? InRequirement.of(kind, Match.AT_LEAST, 1)
                : InRequirement.of(kind, r.match(), r.n());
    }

    private static Finding moving(PlanContext plan, Transition t, OutEdge e, Finding finding) {
        Finding fixed = finding;
        for (TokenKind kind : kinds(plan.flow().pool(t))) {
            fixed = fixed.fixedBy(
                    "Move " + (kind == TokenKind.ANY_TASK ? "tasks" : "robots"),
                    new EdgeEdit.SetOutRequirements(
                            plan.plan().id(),
                            e.id(),
                            e.requirements().stream()
                                    .map(r -> r.kind() == TokenKind.RELEVANT
                                            ? OutRequirement.of(r.action(), r.n(), kind)
                                            : r)
                                    .distinct()
                                    .toList()));
        }
        return fixed;
    }

    /** The kinds of tokens with names that there may be: proxies where none is known of. */
    private static List<TokenKind> kinds(Set<TokenType> kinds) {
        List<TokenKind> named = new ArrayList<>();
        if (kinds.contains(TokenType.PROXY) || !kinds.contains(TokenType.TASK)) {
            named.add(TokenKind.ANY_PROXY);
        }
        if (kinds.contains(TokenType.TASK)) {
            named.add(TokenKind.ANY_TASK);
        }
        return named;
    }

    private static void report(Transition t, String pointer, String edge, String does, Consumer<Finding> report) {
        report.accept(
                t.inputs().isEmpty()
                        ? Finding.error(
                                "E-RELEVANT-WITHOUT-EVENT",
                                pointer,
                                does + " relevant tokens, but the transition has no input event to name them:"
                                        + " speak of robots or tasks, or give it an event",
                                edge,
                                t.id())
                        : Finding.warning(
                                "W-RELEVANT-NOBODY",
                                pointer,
                                does + " relevant tokens, but the input events of the transition name nobody",
                                edge,
                                t.id()));
    }
}
