package org.sami.spn.flow;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Which kinds of tokens can come to which place of a plan: a bound from above, which follows requirements and neither numbers nor order. A
 * mission begins with the generic token, robots and its plan's tasks (R-TOK-2), an instance also with what can come to its parents' places
 * (R-SUB-1, R-SHR-1). Immutable.
 */
public final class ComingTokens {
    private final PlanTokens plan;
    private final Set<TokenType> made;

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
    public Set<TokenType> in(String place) {
        return Collections.unmodifiableSet(plan.at(place));
    }

    /** Whether a kind can stand in a place. */
    public boolean comes(TokenType kind, String place) {
        return plan.at(place).contains(kind);
    }

    /** The kinds that can be in the pool of a transition when it fires. */
    public Set<TokenType> pool(String transition) {
        return plan.pool(transition);
    }

    /** The kinds that a firing can bring along an edge into its place. */
    public Set<TokenType> along(OutEdge edge) {
        return plan.along(edge);
    }

    /** The kinds that the plan's places with sub-missions give their instances, by the id of the plan that runs there. */
    public Map<String, Set<TokenType>> brought() {
        return plan.brought();
    }

    /** The kinds of tokens that an instance of the plan can bring back though it did not start with them. */
    public Set<TokenType> made() {
        return made;
    }
}
