package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;

/** The tasks of a run at one moment: which there are, and of which some news could come that the plan waits for. */
final class TasksNow {
    private final Stepper stepper;
    private final EngineView view;

    TasksNow(Stepper stepper) {
        this.stepper = stepper;
        view = stepper.view();
    }

    /** The tried mission's tasks whose tokens stand somewhere, each once. */
    List<TaskId> standing() {
        Set<TaskId> standing = new LinkedHashSet<>();
        view.mission(stepper.mission())
                .ifPresent(mission -> mission.marking().values().forEach(tokens -> standing.addAll(tasks(tokens))));
        return List.copyOf(standing);
    }

    /**
     * Tasks whose tokens stand where a transition waits for news of that type. Of tasks that can start, those with which a robot
     * begins next.
     */
    List<TaskId> concernedBy(EventType type) {
        Set<TaskId> awaited = new LinkedHashSet<>();
        for (MissionView mission : view.missions()) {
            view.planOf(mission.id())
                    .ifPresent(plan -> plan.transitions().stream()
                            .filter(t -> t.inputs().stream().anyMatch(input -> isOf(type, input.type())))
                            .forEach(t -> awaited.addAll(before(plan, t, mission))));
        }
        if (type.flags().contains(EventFlag.TASK_STARTED)) {
            awaited.retainAll(startable());
        }
        return List.copyOf(awaited);
    }

    private boolean isOf(EventType type, String name) {
        return view.vocabulary().event(name).filter(type::equals).isPresent();
    }

    private static List<TaskId> before(Plan plan, Transition t, MissionView mission) {
        List<TaskId> tasks = new ArrayList<>();
        List<InEdge> edges = plan.inEdgesOf(t.id());
        mission.marking().forEach((place, tokens) -> {
            if (edges.isEmpty() || edges.stream().anyMatch(edge -> edge.place().equals(place))) {
                tasks.addAll(tasks(tokens));
            }
        });
        return tasks;
    }

    private Set<TaskId> startable() {
        Set<TaskId> names = new LinkedHashSet<>();
        stepper.startableTasks().values().forEach(task -> names.addAll(view.namesOf(task)));
        return names;
    }

    private static List<TaskId> tasks(List<Token> tokens) {
        return tokens.stream()
                .filter(Token.Task.class::isInstance)
                .map(token -> ((Token.Task) token).task())
                .distinct()
                .toList();
    }
}
