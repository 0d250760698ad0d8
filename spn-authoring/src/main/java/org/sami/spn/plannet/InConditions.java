package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** The conditions of in edges that do not depend on who is named (thesis 4.1.4), as alternatives of which one must hold. */
final class InConditions {
    private final MissionPlaces places;
    private final PossibleTokens possible;
    private final AbstractionList abstractions;

    InConditions(MissionPlaces places, PossibleTokens possible, AbstractionList abstractions) {
        this.places = places;
        this.possible = possible;
        this.abstractions = abstractions;
    }

    /** The alternatives; none where the transition can never fire. */
    List<CaseArcs> of(Transition t, List<InEdge> edges) {
        List<CaseArcs> alternatives = List.of(new CaseArcs());
        for (InEdge edge : edges) {
            for (InRequirement r : edge.requirements()) {
                if (r.kind() != TokenKind.RELEVANT && r.kind() != TokenKind.UNCONDITIONAL) {
                    alternatives = both(alternatives, of(t, edge.place(), r));
                }
            }
        }
        return alternatives;
    }

    /** Each way in which both hold. */
    static List<CaseArcs> both(List<CaseArcs> first, List<CaseArcs> second) {
        List<CaseArcs> both = new ArrayList<>();
        for (CaseArcs one : first) {
            for (CaseArcs other : second) {
                CaseArcs joined = one.copy();
                joined.join(other);
                if (!joined.isImpossible()) {
                    both.add(joined);
                }
            }
        }
        return both;
    }

    private List<CaseArcs> of(Transition t, String place, InRequirement r) {
        Predicate<PlanToken> counts = token -> r.kind() == TokenKind.TASK
                ? token.isTask(r.task())
                : TokenType.of(r.kind()).contains(token.type());
        List<Integer> counted = places.in(place).entrySet().stream()
                .filter(e -> counts.test(e.getKey()))
                .map(Map.Entry::getValue)
                .toList();
        if (r.asksForNone()) {
            CaseArcs none = new CaseArcs();
            counted.forEach(one -> none.below(one, 1));
            return r.match() == Match.LESS_THAN && r.n() == 0 ? List.of() : List.of(none);
        }
        int least = r.match() == Match.LESS_THAN ? 0 : r.n();
        if (least == 0 && r.match() == Match.AT_LEAST) {
            return List.of(new CaseArcs());
        }
        if (counted.isEmpty()) {
            return least > 0 ? List.of() : List.of(new CaseArcs());
        }
        boolean copies = places.in(place).keySet().stream()
                .anyMatch(token ->
                        counts.test(token) && token.type() != TokenType.GENERIC && possible.isLoose(token, place));
        return copies ? ofCopies(t, place, r, counted, least) : List.of(exactly(place, r, counts, counted, least));
    }

    private CaseArcs exactly(
            String place, InRequirement r, Predicate<PlanToken> counts, List<Integer> counted, int least) {
        int at = counted.size() == 1 ? counted.get(0) : places.counter(place, group(r), counts);
        CaseArcs arcs = new CaseArcs();
        arcs.atLeast(at, least);
        if (r.match() == Match.LESS_THAN) {
            arcs.below(at, r.n());
        } else if (r.match() == Match.EXACTLY) {
            arcs.below(at, r.n() + 1);
        }
        return arcs;
    }

    /** Where a token can be there several times, only that it is there is known. */
    private List<CaseArcs> ofCopies(Transition t, String place, InRequirement r, List<Integer> counted, int least) {
        if (least != 1 || r.match() != Match.AT_LEAST) {
            abstractions.wider(
                    t.id(),
                    "a token can stand in %s several times: that it needs %s of them there is followed only as far as there must be any"
                            .formatted(place, number(r)));
        }
        if (least == 0) {
            return List.of(new CaseArcs());
        }
        List<CaseArcs> alternatives = new ArrayList<>();
        for (int one : counted) {
            CaseArcs arcs = new CaseArcs();
            arcs.atLeast(one, 1);
            alternatives.add(arcs);
        }
        return alternatives;
    }

    private static String number(InRequirement r) {
        return switch (r.match()) {
            case LESS_THAN -> "fewer than " + r.n();
            case EXACTLY -> "exactly " + r.n();
            default -> "at least " + r.n();
        };
    }

    private static String group(InRequirement r) {
        return switch (r.kind()) {
            case ANY_PROXY -> "robots";
            case ANY_TASK -> "tasks";
            case TASK -> "#" + r.task();
            default -> "tokens";
        };
    }
}
