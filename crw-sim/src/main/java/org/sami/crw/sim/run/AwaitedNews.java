package org.sami.crw.sim.run;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.handler.activation.EventNames;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Whether missions wait for something that comes by itself: a reading, a battery's level, a boat that enters an area, the answer of a
 * service. What the engine makes, what the operator answers and what becomes of commands does not: who has none of them under way
 * gets none.
 */
final class AwaitedNews {
    private final Vocabulary vocabulary;
    private final Project project;
    private final Set<String> answers = new HashSet<>(EventNames.OF_COMMANDS);

    AwaitedNews(Vocabulary vocabulary, Project project) {
        this.vocabulary = vocabulary;
        this.project = project;
        for (EventType type : vocabulary.events().values()) {
            type.decision().map(DecisionType::accepted).ifPresent(answers::add);
            type.decision().map(DecisionType::rejected).ifPresent(answers::add);
        }
    }

    /** Whether a transition that has a marked place, or needs none, waits for such an event. */
    boolean isAwaited(EngineView view) {
        return view.missions().stream()
                .anyMatch(mission -> project.plan(mission.plan()).stream()
                        .flatMap(plan -> plan.transitions().stream().filter(t -> isNear(mission, plan, t)))
                        .flatMap(t -> view.whyNotEnabled(mission.id(), t.id()).awaited().stream())
                        .anyMatch(input -> comesByItself(input.type())));
    }

    private static boolean isNear(MissionView mission, Plan plan, Transition transition) {
        List<String> places =
                plan.inEdgesOf(transition.id()).stream().map(InEdge::place).toList();
        return places.isEmpty() || places.stream().anyMatch(mission.marking()::containsKey);
    }

    private boolean comesByItself(String nameOrAlias) {
        return vocabulary
                .event(nameOrAlias)
                .filter(type -> type.role() == EventRole.NONE && !answers.contains(type.name()))
                .isPresent();
    }
}
