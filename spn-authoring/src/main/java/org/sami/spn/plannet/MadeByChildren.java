package org.sami.spn.plannet;

import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** Which types of tokens sub-missions can bring back that do not stand in their place. */
final class MadeByChildren {
    private final Project project;
    private final Vocabulary vocabulary;

    MadeByChildren(Project project, Vocabulary vocabulary) {
        this.project = project;
        this.vocabulary = vocabulary;
    }

    /**
     * What the sub-missions on the in places of a transition can bring back so.
     *
     * @param hasGenerics to which places of the plan generic tokens can come
     */
    Set<TokenType> whereNobodyStands(Plan plan, Transition t, Predicate<String> hasGenerics) {
        Set<TokenType> made = EnumSet.noneOf(TokenType.class);
        plan.inEdgesOf(t.id()).forEach(edge -> {
            made.addAll(by(plan, edge.place()));
            if (hasGenerics.test(edge.place())) {
                addNameless(plan, edge.place(), made);
            }
        });
        return made;
    }

    /** What the plans of a place's sub-missions make or copy, and bring to their ends. */
    Set<TokenType> by(Plan plan, String place) {
        return by(plan, place, Set.of(plan.id()));
    }

    private Set<TokenType> by(Plan parent, String place, Set<String> ancestors) {
        Set<TokenType> made = EnumSet.noneOf(TokenType.class);
        parent.place(place).stream()
                .flatMap(p -> p.subMissions().stream())
                .flatMap(sub -> project.plan(sub.plan()).stream())
                .forEach(child -> made.addAll(by(child, ancestors)));
        return made;
    }

    private Set<TokenType> by(Plan child, Set<String> ancestors) {
        if (ancestors.contains(child.id())) {
            return EnumSet.allOf(TokenType.class); // a plan that runs itself
        }
        Set<String> withChild = new HashSet<>(ancestors);
        withChild.add(child.id());
        Set<TokenType> made = EnumSet.noneOf(TokenType.class);
        child.transitions().forEach(t -> addMade(child, t, made));
        child.places().forEach(place -> {
            made.addAll(by(child, place.id(), withChild));
            addNameless(child, place.id(), made);
        });
        made.retainAll(comingToEnds(child));
        return made;
    }

    private static Set<TokenType> comingToEnds(Plan child) {
        return child.outEdges().stream()
                .filter(edge -> child.place(edge.place()).filter(Place::end).isPresent())
                .flatMap(edge -> edge.requirements().stream())
                .filter(r -> r.action() != Action.CONSUME)
                .flatMap(r -> types(r).stream())
                .collect(Collectors.toCollection(() -> EnumSet.noneOf(TokenType.class)));
    }

    /** What a firing of a child can make or copy. */
    private static void addMade(Plan child, Transition t, Set<TokenType> made) {
        List<OutEdge> edges = child.outEdgesOf(t.id()).stream()
                .filter(edge -> edge.requirements().stream().anyMatch(r -> r.action() == Action.TAKE))
                .toList();
        child.outEdgesOf(t.id()).stream()
                .flatMap(edge -> edge.requirements().stream())
                .filter(r -> r.action() == Action.ADD || (r.action() == Action.TAKE && edges.size() > 1))
                .forEach(r -> made.addAll(types(r)));
    }

    private static Set<TokenType> types(OutRequirement r) {
        return r.kind() == TokenKind.SUB_MISSION_TOKENS ? EnumSet.allOf(TokenType.class) : TokenType.of(r.kind());
    }

    /**
     * Generic tokens come back without one that stands there, as they have no names: where several sub-missions got the same one, and where an interrupt took one out of the
     * place, which does not take it out of the sub-mission (R-SUB-4, R-INT-7).
     */
    private void addNameless(Plan plan, String place, Set<TokenType> made) {
        long subs = plan.place(place).stream()
                .flatMap(p -> p.subMissions().stream())
                .flatMap(sub -> project.plan(sub.plan()).stream())
                .filter(child -> comingToEnds(child).contains(TokenType.GENERIC))
                .count();
        boolean isPulled = plan.inEdges().stream()
                .filter(edge -> edge.place().equals(place))
                .flatMap(edge -> plan.transition(edge.transition()).stream())
                .filter(t -> EventReach.reachesHeld(vocabulary, t))
                .flatMap(t -> plan.outEdgesOf(t.id()).stream())
                .flatMap(edge -> edge.requirements().stream())
                .anyMatch(r ->
                        r.action() != Action.ADD && (r.kind() == TokenKind.GENERIC || r.kind() == TokenKind.ANY_TOKEN));
        if (subs > 1 || (subs == 1 && isPulled)) {
            made.add(TokenType.GENERIC);
        }
    }
}
