package org.sami.spn.analysis;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * Finds transitions that watch two places for one answer and require that all tokens that it names are in the first. Another transition
 * takes tokens from the first place to the second, where their commands go on: an answer that arrives then is never taken.
 */
final class MissedAnswers implements PlanCheck {
    private static final Set<TokenKind> MOVES_PROXIES =
            EnumSet.of(TokenKind.ANY_PROXY, TokenKind.ANY_TOKEN, TokenKind.RELEVANT);

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-ANSWER-MISSED",
                "An answer that names somebody in the second place never fires the transition: that robot or "
                        + "task stays there.",
                "Ask for at least 1 relevant token, or draw a transition for each place."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            if (plan.inputsOf(t).stream().noneMatch(i -> i.type().tokens() != TokenNeed.NONE)) {
                continue;
            }
            for (InEdge asking : plan.inEdges(t)) {
                if (asking.requirements().stream()
                        .anyMatch(r -> r.kind() == TokenKind.RELEVANT && r.match() == Match.ALL)) {
                    plan.place(asking.place())
                            .ifPresent(first -> secondPlaces(plan, t, first)
                                    .forEach(second -> report.accept(finding(plan, t, asking, first, second))));
                }
            }
        }
    }

    /** In places without a condition, into which another transition takes proxies out of the first. */
    private static List<Place> secondPlaces(PlanContext plan, Transition t, Place first) {
        return plan.inEdges(t).stream()
                .filter(e -> !e.place().equals(first.id()))
                .filter(e -> e.requirements().stream().allMatch(r -> r.kind() == TokenKind.UNCONDITIONAL))
                .flatMap(e -> plan.place(e.place()).stream())
                .filter(second -> plan.outTransitions(first).stream()
                        .filter(u -> !u.id().equals(t.id()))
                        .flatMap(u -> plan.outEdges(u).stream())
                        .anyMatch(e -> e.place().equals(second.id()) && takesProxies(e)))
                .toList();
    }

    private static boolean takesProxies(OutEdge edge) {
        return edge.requirements().stream()
                .anyMatch(r -> r.action() == Action.TAKE && MOVES_PROXIES.contains(r.kind()));
    }

    private static Finding finding(PlanContext plan, Transition t, InEdge asking, Place first, Place second) {
        return Finding.warning(
                "W-ANSWER-MISSED",
                plan.at(asking),
                "The " + plan.name(t) + " watches the " + plan.name(first) + " and the "
                        + plan.name(second) + ", but requires that all tokens that its answer names are in the first: "
                        + "an answer of one that stands in the second is never taken. Ask for \"at least 1 relevant\","
                        + " or draw a transition for each place",
                asking.id(),
                t.id(),
                second.id());
    }
}
