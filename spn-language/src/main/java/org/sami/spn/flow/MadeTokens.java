package org.sami.spn.flow;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Which kinds of tokens the firings of a plan make from nothing: generic ones, and those of robots and tasks that their input events name. */
final class MadeTokens {
    private final Map<String, Plan> plans = new HashMap<>();
    private final Vocabulary vocabulary;

    MadeTokens(Project project, Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
        project.plans().forEach(p -> plans.putIfAbsent(p.id(), p));
    }

    /** What an instance of a plan can bring back though it did not start with it. The plan's own tasks never return (R-SUB-7). */
    Set<TokenType> by(Plan plan) {
        Set<TokenType> made = EnumSet.noneOf(TokenType.class);
        by(plan, made, new HashSet<>());
        return made;
    }

    /** The same of all plans that run at once on a place. */
    Set<TokenType> by(List<SubMissionSpec> subMissions) {
        Set<TokenType> made = EnumSet.noneOf(TokenType.class);
        Set<String> seen = new HashSet<>();
        subMissions.forEach(sub -> by(sub, made, seen));
        return made;
    }

    private void by(SubMissionSpec sub, Set<TokenType> made, Set<String> seen) {
        Optional.ofNullable(plans.get(sub.plan())).ifPresent(child -> by(child, made, seen));
    }

    private void by(Plan plan, Set<TokenType> made, Set<String> seen) {
        if (!seen.add(plan.id())) {
            return;
        }
        for (OutEdge edge : plan.outEdges()) {
            for (OutRequirement r : edge.requirements()) {
                if (makesGeneric(r)) {
                    made.add(TokenType.GENERIC);
                } else if (r.action() == Action.ADD && r.kind() == TokenKind.RELEVANT) {
                    plan.transition(edge.transition()).ifPresent(t -> made.addAll(named(t, false)));
                }
            }
        }
        plan.places().forEach(p -> p.subMissions().forEach(sub -> by(sub, made, seen)));
    }

    /** Whether generic tokens are made of which none is needed in the pool (R-OUT-4). */
    static boolean makesGeneric(OutRequirement r) {
        return r.action() == Action.ADD && r.kind() == TokenKind.GENERIC && !r.takesAll();
    }

    /** Whom the input events of a transition can name. Of an event that the vocabulary does not have, that can be anybody. */
    Set<TokenType> named(Transition t, boolean ownTasks) {
        Set<TokenType> named = EnumSet.noneOf(TokenType.class);
        t.inputs().forEach(input -> {
            Optional<EventType> type = vocabulary.event(input.type());
            boolean own =
                    type.filter(e -> e.role() == EventRole.TASKS_GENERATED).isPresent();
            if (ownTasks || !own) {
                named.addAll(type.map(NamedTokens::of).orElse(EnumSet.of(TokenType.PROXY, TokenType.TASK)));
            }
        });
        return named;
    }
}
