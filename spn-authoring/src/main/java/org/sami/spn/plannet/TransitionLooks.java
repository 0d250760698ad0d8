package org.sami.spn.plannet;

import java.util.List;
import java.util.Optional;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** What the edges of a transition tell of when it fires, and of whom it selects. */
final class TransitionLooks {
    private TransitionLooks() {}

    /** Whether a transition without input events is looked at again by itself whenever it could fire: then it needs no mark. */
    static boolean looksAgain(Plan plan, PossibleTokens possible, Transition t) {
        List<InEdge> edges = plan.inEdgesOf(t.id());
        return edges.stream().anyMatch(edge -> possible.hasSub(edge.place()))
                || edges.stream()
                        .anyMatch(edge ->
                                edge.requirements().stream().anyMatch(in -> isTaken(plan.outEdgesOf(t.id()), in)));
    }

    /** Whether its only input event reaches it as an answer or as news: where it must have somebody who is named, one of them is there. */
    static boolean isToldNames(Vocabulary vocabulary, Transition t) {
        return t.inputs().size() == 1
                && t.inputs().stream()
                        .flatMap(input -> vocabulary.event(input.type()).stream())
                        .map(EventType::role)
                        .noneMatch(role -> role == EventRole.SUB_MISSION_ABORTED
                                || role == EventRole.CHECK_RETURN
                                || role.isPress());
    }

    /** Whether an event that waits can let it fire once nobody is in its in places: it asks for no token, and may be kept waiting (R-LOOK-5). */
    static boolean mayFireLater(Plan plan, PossibleTokens possible, Vocabulary vocabulary, Transition t) {
        boolean isKept = t.inputs().stream()
                .flatMap(input -> vocabulary.event(input.type()).stream())
                .anyMatch(type -> !type.role().isPress());
        List<InEdge> edges = plan.inEdgesOf(t.id());
        boolean mustBeNamed = isToldNames(vocabulary, t);
        boolean asksForOne = edges.stream()
                .flatMap(edge -> edge.requirements().stream())
                .anyMatch(in -> in.kind() == TokenKind.RELEVANT
                        ? mustBeNamed && (in.match() == Match.ALL || isAtLeastOne(in))
                        : in.kind() != TokenKind.UNCONDITIONAL && isAtLeastOne(in));
        boolean waits = t.inputs().size() > 1
                || t.waitFor() == WaitFor.ALL
                || edges.stream().anyMatch(edge -> possible.hasSub(edge.place()))
                || edges.stream()
                        .flatMap(edge -> edge.requirements().stream())
                        .anyMatch(in -> in.kind() != TokenKind.UNCONDITIONAL);
        return isKept && !edges.isEmpty() && !asksForOne && waits;
    }

    private static boolean isAtLeastOne(InRequirement in) {
        return (in.match() == Match.AT_LEAST || in.match() == Match.EXACTLY) && in.n() > 0;
    }

    /** Whether each firing removes a token that the requirement counts. */
    private static boolean isTaken(List<OutEdge> outs, InRequirement in) {
        return isAtLeastOne(in)
                && in.kind() != TokenKind.RELEVANT
                && in.kind() != TokenKind.UNCONDITIONAL
                && outs.stream()
                        .flatMap(out -> out.requirements().stream())
                        .anyMatch(out -> out.action() != Action.ADD
                                && out.takesAll()
                                && (out.kind() == in.kind() || out.kind() == TokenKind.ANY_TOKEN)
                                && out.task().equals(in.task()));
    }

    /** Whether it takes only some of several tokens. */
    static Optional<OutRequirement> choosing(Plan plan, Transition t) {
        return plan.outEdgesOf(t.id()).stream()
                .flatMap(edge -> edge.requirements().stream())
                .filter(r -> !r.takesAll()
                        && r.n() > 0
                        && r.kind() != TokenKind.GENERIC
                        && r.kind() != TokenKind.UNCONDITIONAL)
                .findFirst();
    }
}
