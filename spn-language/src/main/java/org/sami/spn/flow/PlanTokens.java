package org.sami.spn.flow;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** Follows kinds of tokens through one plan, as far as is known with what it starts. */
final class PlanTokens {
    private final Plan plan;
    private final MadeTokens makers;
    private final Map<String, Place> places = new HashMap<>();
    private final Map<String, Transition> transitions = new HashMap<>();
    private final Map<String, List<InEdge>> before;
    private final Map<String, List<OutEdge>> behind;
    private final Map<String, List<InEdge>> outOf;
    private final Map<String, Set<TokenType>> at = new HashMap<>();
    private final Deque<String> open = new ArrayDeque<>();

    PlanTokens(Plan plan, Vocabulary vocabulary, MadeTokens makers) {
        this.plan = plan;
        this.makers = makers;
        plan.places().forEach(p -> places.putIfAbsent(p.id(), p));
        plan.transitions().forEach(t -> transitions.putIfAbsent(t.id(), t));
        before = plan.inEdges().stream().collect(Collectors.groupingBy(InEdge::transition));
        behind = plan.outEdges().stream().collect(Collectors.groupingBy(OutEdge::transition));
        outOf = plan.inEdges().stream().collect(Collectors.groupingBy(InEdge::place));
        start(EnumSet.of(TokenType.GENERIC, TokenType.PROXY));
        if (!plan.tasks().isEmpty()) {
            start(EnumSet.of(TokenType.TASK));
        }
        open.addAll(transitions.keySet());
    }

    /** Starts with these kinds as well. Returns whether there is more to follow. */
    boolean start(Set<TokenType> kinds) {
        boolean more = false;
        for (Place place : plan.places()) {
            more |= place.start() && add(place.id(), kinds);
        }
        return more;
    }

    private boolean add(String place, Set<TokenType> kinds) {
        boolean more =
                at.computeIfAbsent(place, p -> EnumSet.noneOf(TokenType.class)).addAll(kinds);
        if (more) {
            outOf.getOrDefault(place, List.of()).forEach(e -> open.add(e.transition()));
        }
        return more;
    }

    /** Follows the tokens that are not followed yet. */
    void follow() {
        while (!open.isEmpty()) {
            for (OutEdge edge : behind.getOrDefault(open.poll(), List.of())) {
                if (places.containsKey(edge.place())) {
                    add(edge.place(), along(edge));
                }
            }
        }
    }

    Set<TokenType> at(String place) {
        return at.getOrDefault(place, Set.of());
    }

    /** What places with sub-missions give their instances, by the plan that runs there. */
    Map<String, Set<TokenType>> brought() {
        Map<String, Set<TokenType>> brought = new TreeMap<>();
        for (Place place : plan.places()) {
            place.subMissions()
                    .forEach(sub -> brought.computeIfAbsent(sub.plan(), p -> EnumSet.noneOf(TokenType.class))
                            .addAll(at(place.id())));
        }
        return brought;
    }

    Set<TokenType> pool(String transition) {
        List<InEdge> edges = before.getOrDefault(transition, List.of());
        Set<TokenType> pool = EnumSet.noneOf(TokenType.class);
        for (InEdge edge : edges) {
            Set<TokenType> here = EnumSet.noneOf(TokenType.class);
            here.addAll(at(edge.place()));
            edges.stream()
                    .filter(e -> e.place().equals(edge.place()))
                    .flatMap(e -> e.requirements().stream())
                    .filter(InRequirement::asksForNone)
                    .filter(r -> r.kind() != TokenKind.TASK && r.kind() != TokenKind.RELEVANT) // others may be there
                    .forEach(r -> here.removeAll(TokenType.of(r.kind())));
            pool.addAll(here);
        }
        return pool;
    }

    Set<TokenType> along(OutEdge edge) {
        Set<TokenType> moved = EnumSet.noneOf(TokenType.class);
        Transition t = transitions.get(edge.transition());
        if (t != null) {
            Set<TokenType> pool = pool(t.id());
            edge.requirements().stream()
                    .filter(r -> r.action() != Action.CONSUME)
                    .forEach(r -> moved.addAll(moved(r, pool, t)));
        }
        return moved;
    }

    private Set<TokenType> moved(OutRequirement r, Set<TokenType> pool, Transition t) {
        Set<TokenType> moved = EnumSet.noneOf(TokenType.class);
        if (MadeTokens.makesGeneric(r)) {
            moved.add(TokenType.GENERIC);
        } else if (r.kind() == TokenKind.RELEVANT) {
            moved.addAll(r.action() == Action.ADD ? makers.named(t, true) : relevant(t));
            if (r.action() != Action.ADD) {
                moved.retainAll(pool);
            }
        } else if (r.kind() == TokenKind.SUB_MISSION_TOKENS) {
            moved.addAll(pool);
            for (InEdge edge : before.getOrDefault(t.id(), List.of())) {
                Place place = places.get(edge.place());
                if (place != null) {
                    moved.addAll(makers.by(place.subMissions()));
                }
            }
        } else {
            moved.addAll(TokenType.of(r.kind()));
            moved.retainAll(pool);
        }
        return moved;
    }

    /** The relevant tokens: those that an event can name; a robot's name also speaks of its tasks (R-REL-3). */
    private Set<TokenType> relevant(Transition t) {
        Set<TokenType> relevant = EnumSet.noneOf(TokenType.class);
        relevant.addAll(makers.named(t, true));
        if (relevant.contains(TokenType.PROXY)) {
            relevant.add(TokenType.TASK);
        }
        return relevant;
    }
}
