package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.flow.ComingTokens;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/** What checks ask about the ways of tokens through a plan: which kinds {@link ComingTokens} lets come where, and where they can go on to. */
final class TokenFlow {
    private final PlanContext plan;
    private final ComingTokens coming;
    private final Map<String, Set<TokenType>> along = new HashMap<>();

    TokenFlow(PlanContext plan) {
        this.plan = plan;
        coming = new ComingTokens(plan.project(), plan.plan(), plan.vocabulary());
    }

    /** The kinds that may stand in a place. */
    Set<TokenType> at(Place place) {
        return coming.in(place.id());
    }

    /** The kinds that a firing may bring along an edge into its place. */
    Set<TokenType> along(OutEdge edge) {
        return along.computeIfAbsent(edge.id(), id -> coming.along(edge));
    }

    /** The kinds that may stand in the places before a transition when it fires. */
    Set<TokenType> pool(Transition t) {
        return coming.pool(t.id());
    }

    /** What sub-missions of the plan start with, by the plan that runs there. */
    Map<String, Set<TokenType>> brought() {
        return coming.brought();
    }

    /** What an instance of the plan can bring back though it did not start with it. */
    Set<TokenType> made() {
        return coming.made();
    }

    /** The places to which tokens of some kinds may come from others by some transitions; those left out unless a way leads back. */
    Set<String> reached(Set<String> from, Set<TokenType> kinds, Predicate<Transition> by) {
        Set<String> reached = new HashSet<>();
        Deque<String> open = new ArrayDeque<>(from);
        while (!open.isEmpty()) {
            String place = open.pop();
            for (Transition t : plan.place(place).map(plan::outTransitions).orElse(List.of())) {
                boolean leaves = by.test(t)
                        && plan.inEdges(t).stream()
                                .filter(e -> e.place().equals(place))
                                .flatMap(e -> e.requirements().stream())
                                .noneMatch(InRequirement::asksForNone);
                for (OutEdge edge : leaves ? plan.outEdges(t) : List.<OutEdge>of()) {
                    if (along(edge).stream().anyMatch(kinds::contains) && reached.add(edge.place())) {
                        open.push(edge.place());
                    }
                }
            }
        }
        return reached;
    }
}
