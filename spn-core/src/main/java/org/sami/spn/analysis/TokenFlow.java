package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * Which kinds of tokens may come to which place of a plan: a bound from above, which follows requirements and not numbers. A plan that
 * others run may get every kind.
 */
final class TokenFlow {
    /** The kinds of tokens. */
    enum Kind {
        GENERIC,
        PROXY,
        TASK
    }

    private final PlanContext plan;
    private final Map<String, Set<Kind>> at = new HashMap<>();
    private final Map<String, Set<Kind>> along = new HashMap<>(); // by edge, once all is known

    TokenFlow(PlanContext plan) {
        this.plan = plan;
        Deque<Transition> open = new ArrayDeque<>();
        Set<Kind> start = EnumSet.of(Kind.GENERIC, Kind.PROXY);
        if (!plan.plan().tasks().isEmpty() || !plan.parents().isEmpty()) {
            start.add(Kind.TASK);
        }
        plan.plan().places().stream().filter(Place::start).forEach(p -> add(p, start, open));
        for (Transition t : plan.plan().transitions()) {
            if (plan.inEdges(t).isEmpty()) {
                open.add(t);
            }
        }
        while (!open.isEmpty()) {
            Transition t = open.pop();
            for (OutEdge edge : plan.outEdges(t)) {
                Set<Kind> moved = moved(edge);
                plan.place(edge.place()).ifPresent(p -> add(p, moved, open));
            }
        }
    }

    private void add(Place place, Set<Kind> kinds, Deque<Transition> open) {
        if (at.computeIfAbsent(place.id(), p -> EnumSet.noneOf(Kind.class)).addAll(kinds)) {
            open.addAll(plan.outTransitions(place));
        }
    }

    /** The kinds that may stand in a place. */
    Set<Kind> at(Place place) {
        return at.getOrDefault(place.id(), Set.of());
    }

    /** The kinds that a firing may bring along an edge into its place. */
    Set<Kind> along(OutEdge edge) {
        return along.computeIfAbsent(edge.id(), id -> moved(edge));
    }

    private Set<Kind> moved(OutEdge edge) {
        Set<Kind> moved = EnumSet.noneOf(Kind.class);
        plan.transition(edge.transition()).ifPresent(t -> {
            Set<Kind> pool = pool(t);
            edge.requirements().stream()
                    .filter(r -> r.action() != Action.CONSUME)
                    .forEach(r -> moved.addAll(moved(r, pool, plan.inputsOf(t))));
        });
        return moved;
    }

    /** The kinds that may stand in the places before a transition when it fires. */
    Set<Kind> pool(Transition t) {
        Set<Kind> pool = EnumSet.noneOf(Kind.class);
        for (InEdge edge : plan.inEdges(t)) {
            Set<Kind> here = EnumSet.noneOf(Kind.class);
            plan.place(edge.place()).ifPresent(p -> here.addAll(at(p)));
            edge.requirements().stream().filter(TokenFlow::forbids).forEach(r -> here.removeAll(kinds(r.kind())));
            pool.addAll(here);
        }
        return pool;
    }

    private static boolean forbids(InRequirement r) {
        return r.kind() != TokenKind.TASK && ForgottenPlaces.isAbsence(r);
    }

    private static Set<Kind> moved(OutRequirement r, Set<Kind> pool, List<PlacedInput> inputs) {
        boolean add = r.action() == Action.ADD;
        if (r.kind() == TokenKind.RELEVANT) {
            return add ? named(inputs) : common(EnumSet.of(Kind.PROXY, Kind.TASK), pool);
        }
        if (r.kind() == TokenKind.GENERIC && add && !r.takesAll()) {
            return EnumSet.of(Kind.GENERIC);
        }
        return common(r.kind() == TokenKind.SUB_MISSION_TOKENS ? EnumSet.allOf(Kind.class) : kinds(r.kind()), pool);
    }

    private static Set<Kind> common(Set<Kind> kinds, Set<Kind> pool) {
        Set<Kind> common = EnumSet.noneOf(Kind.class);
        common.addAll(kinds);
        common.retainAll(pool);
        return common;
    }

    private static Set<Kind> named(List<PlacedInput> inputs) {
        Set<Kind> named = EnumSet.noneOf(Kind.class);
        for (PlacedInput input : inputs) {
            TokenNeed tokens = input.type().tokens();
            EventRole role = input.type().role();
            if (tokens == TokenNeed.TASK || tokens == TokenNeed.PROXY_OR_TASK || role == EventRole.TASKS_GENERATED) {
                named.add(Kind.TASK);
            }
            boolean ofRole = role != EventRole.NONE && role != EventRole.TASKS_GENERATED && tokens == TokenNeed.NONE;
            if (tokens == TokenNeed.PROXY || tokens == TokenNeed.PROXY_OR_TASK || ofRole) {
                named.add(Kind.PROXY);
            }
        }
        return named;
    }

    /** The places to which tokens of some kinds may come from others by some transitions; those left out unless a way leads back. */
    Set<String> reached(Set<String> from, Set<Kind> kinds, Predicate<Transition> by) {
        Set<String> reached = new HashSet<>();
        Deque<String> open = new ArrayDeque<>(from);
        while (!open.isEmpty()) {
            String place = open.pop();
            for (Transition t : plan.place(place).map(plan::outTransitions).orElse(List.of())) {
                boolean leaves = by.test(t)
                        && plan.inEdges(t).stream()
                                .filter(e -> e.place().equals(place))
                                .flatMap(e -> e.requirements().stream())
                                .noneMatch(ForgottenPlaces::isAbsence);
                for (OutEdge edge : leaves ? plan.outEdges(t) : List.<OutEdge>of()) {
                    if (along(edge).stream().anyMatch(kinds::contains) && reached.add(edge.place())) {
                        open.push(edge.place());
                    }
                }
            }
        }
        return reached;
    }

    /** The kinds of tokens that a requirement speaks of; of relevant ones those that have a name. */
    static Set<Kind> kinds(TokenKind kind) {
        return switch (kind) {
            case GENERIC -> EnumSet.of(Kind.GENERIC);
            case ANY_PROXY -> EnumSet.of(Kind.PROXY);
            case ANY_TASK, TASK -> EnumSet.of(Kind.TASK);
            case ANY_TOKEN -> EnumSet.allOf(Kind.class);
            case RELEVANT -> EnumSet.of(Kind.PROXY, Kind.TASK);
            case SUB_MISSION_TOKENS, UNCONDITIONAL -> EnumSet.noneOf(Kind.class);
        };
    }
}
