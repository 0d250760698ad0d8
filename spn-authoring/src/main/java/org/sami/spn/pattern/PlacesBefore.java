package org.sami.spn.pattern;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.flow.ComingTokens;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.wiring.WaysBack;

/**
 * Who can still come to a place, and from where: the places before it in which tokens of a kind can stand. Of robots, those are left out that
 * stay behind by choice: in the start, and where the operator chooses some of them.
 */
final class PlacesBefore {
    private final PatternSpot spot;
    private final ComingTokens coming;

    PlacesBefore(PatternSpot spot) {
        this.spot = spot;
        this.coming = spot.coming();
    }

    /** The kind of tokens that a plan waits for in a place: tasks where any can come, else robots; empty where neither comes. */
    Optional<TokenKind> kind(String here) {
        return coming.comes(TokenType.TASK, here)
                ? Optional.of(TokenKind.ANY_TASK)
                : coming.comes(TokenType.PROXY, here) ? Optional.of(TokenKind.ANY_PROXY) : Optional.empty();
    }

    /** The places from which tokens of a kind can still come to one of some places. */
    Set<String> before(Collection<String> here, TokenKind kind) {
        return before(here, kind, t -> true);
    }

    /**
     * The same without those whose robots have not begun with their task: a robot that has several tasks is never with all of them at a
     * time.
     */
    Set<String> onTheWay(Collection<String> here, TokenKind kind) {
        return before(
                here,
                kind,
                t -> t.inputs().stream()
                        .flatMap(i -> spot.vocabulary().event(i.type()).stream())
                        .noneMatch(e -> e.flags().contains(EventFlag.TASK_STARTED)));
    }

    private Set<String> before(Collection<String> here, TokenKind kind, Predicate<Transition> passes) {
        Plan plan = spot.plan();
        Set<String> found = new LinkedHashSet<>();
        Deque<String> open = new ArrayDeque<>(here);
        while (!open.isEmpty()) {
            String at = open.remove();
            plan.outEdges().stream()
                    .filter(e -> e.place().equals(at))
                    .filter(e -> plan.transition(e.transition()).filter(passes).isPresent())
                    .flatMap(e -> plan.inEdgesOf(e.transition()).stream())
                    .filter(WaysBack::isWay)
                    .map(e -> plan.place(e.place()))
                    .flatMap(Optional::stream)
                    .filter(p -> !here.contains(p.id()) && comes(p, kind) && !leavesSome(p, kind))
                    .filter(p -> found.add(p.id()))
                    .forEach(p -> open.add(p.id()));
        }
        return found;
    }

    private boolean comes(Place place, TokenKind kind) {
        return coming.comes(kind == TokenKind.ANY_TASK ? TokenType.TASK : TokenType.PROXY, place.id());
    }

    private boolean leavesSome(Place place, TokenKind kind) {
        return kind == TokenKind.ANY_PROXY
                && (place.start()
                        || place.outputs().stream()
                                .flatMap(o -> spot.vocabulary().event(o.type()).stream())
                                .map(EventType::decision)
                                .flatMap(Optional::stream)
                                .anyMatch(d -> d.form() == DecisionForm.CHOOSE_PROXIES));
    }
}
