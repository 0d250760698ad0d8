package org.sami.spn.flow;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Which kinds of tokens can come to which place of a plan: a bound from above, which follows requirements and neither numbers nor order. A
 * mission begins with the generic token, robots and its plan's tasks (R-TOK-2), an instance also with what can come to its parents' places
 * (R-SUB-1, R-SHR-1). Immutable.
 */
public final class ComingTokens {
    /** The kinds of tokens. */
    public enum Kind {
        GENERIC,
        PROXY,
        TASK
    }

    private final PlanTokens plan;
    private final Set<Kind> made;

    /** The tokens of a plan of a project. */
    public ComingTokens(Project project, Plan plan, Vocabulary vocabulary) {
        MadeTokens makers = new MadeTokens(project, vocabulary);
        made = makers.by(plan);
        Map<String, PlanTokens> above = above(project, plan, vocabulary, makers);
        Deque<PlanTokens> open = new ArrayDeque<>(above.values());
        while (!open.isEmpty()) {
            PlanTokens parent = open.poll();
            parent.follow();
            parent.brought()
                    .forEach((child, kinds) -> Optional.ofNullable(above.get(child))
                            .filter(tokens -> tokens.start(kinds))
                            .ifPresent(open::add));
        }
        this.plan = Objects.requireNonNull(above.get(plan.id()), plan.id());
    }

    /** The plan and those that run it as a sub-mission, at any depth, by id. */
    private static Map<String, PlanTokens> above(Project project, Plan plan, Vocabulary vocabulary, MadeTokens makers) {
        Map<String, PlanTokens> above = new LinkedHashMap<>();
        Deque<Plan> open = new ArrayDeque<>(Set.of(plan));
        while (!open.isEmpty()) {
            Plan next = open.pop();
            if (above.putIfAbsent(next.id(), new PlanTokens(next, vocabulary, makers)) == null) {
                project.plans().stream().filter(p -> runs(p, next.id())).forEach(open::push);
            }
        }
        return above;
    }

    private static boolean runs(Plan parent, String child) {
        return parent.places().stream()
                .flatMap(p -> p.subMissions().stream())
                .map(SubMissionSpec::plan)
                .anyMatch(child::equals);
    }

    /** The kinds that can stand in a place. */
    public Set<Kind> in(String place) {
        return Collections.unmodifiableSet(plan.at(place));
    }

    /** Whether a kind can stand in a place. */
    public boolean comes(Kind kind, String place) {
        return plan.at(place).contains(kind);
    }

    /** The kinds that can be in the pool of a transition when it fires. */
    public Set<Kind> pool(String transition) {
        return plan.pool(transition);
    }

    /** The kinds that a firing can bring along an edge into its place. */
    public Set<Kind> along(OutEdge edge) {
        return plan.along(edge);
    }

    /** The kinds that the plan's places with sub-missions give their instances, by the id of the plan that runs there. */
    public Map<String, Set<Kind>> brought() {
        return plan.brought();
    }

    /** The kinds of tokens that an instance of the plan can bring back though it did not start with them. */
    public Set<Kind> made() {
        return made;
    }

    /** The kinds of tokens that a requirement speaks of; of relevant ones those that have a name. */
    public static Set<Kind> kinds(TokenKind kind) {
        return switch (kind) {
            case GENERIC -> EnumSet.of(Kind.GENERIC);
            case ANY_PROXY -> EnumSet.of(Kind.PROXY);
            case ANY_TASK, TASK -> EnumSet.of(Kind.TASK);
            case ANY_TOKEN -> EnumSet.allOf(Kind.class);
            case RELEVANT -> EnumSet.of(Kind.PROXY, Kind.TASK);
            case SUB_MISSION_TOKENS, UNCONDITIONAL -> EnumSet.noneOf(Kind.class);
        };
    }

    /** Whether a requirement asks that nobody of its kind is there. */
    public static boolean isAbsence(InRequirement r) {
        return r.match() == Match.ZERO
                || (r.match() == Match.LESS_THAN && r.n() <= 1)
                || (r.match() == Match.EXACTLY && r.n() == 0);
    }
}
