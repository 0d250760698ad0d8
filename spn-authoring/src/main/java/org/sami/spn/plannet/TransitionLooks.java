package org.sami.spn.plannet;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
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

    /** Whether an event can let it fire once nobody is in its in places: it asks for no token, and the event may be kept waiting (R-LOOK-5) or come to others first. */
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
        return !edges.isEmpty() && !asksForOne && ((isKept && waits) || isToldWithOthers(plan, t));
    }

    /**
     * Whether one event may come to it and to another transition with an in place in common: all to whom it comes receive it before the first of them fires (R-OCC-6), so
     * the other one may have emptied that place when the turn comes to this one (R-LOOK-7).
     */
    private static boolean isToldWithOthers(Plan plan, Transition t) {
        Set<String> types = types(t);
        Set<String> places = inPlaces(plan, t);
        return plan.transitions().stream()
                .filter(other -> !other.id().equals(t.id()))
                .anyMatch(other -> !Collections.disjoint(types, types(other))
                        && !Collections.disjoint(places, inPlaces(plan, other)));
    }

    private static Set<String> types(Transition t) {
        return t.inputs().stream().map(InputEventSpec::type).collect(Collectors.toSet());
    }

    private static Set<String> inPlaces(Plan plan, Transition t) {
        return plan.inEdgesOf(t.id()).stream().map(InEdge::place).collect(Collectors.toSet());
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
