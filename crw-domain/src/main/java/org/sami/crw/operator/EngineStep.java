package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.operator.MissionModel.StartedPlan;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * What one step of the engine means to the models, with all that must be asked on the engine's thread; immutable.
 *
 * @param presentations decisions that it opened, as they are to be shown
 * @param plans of missions that it started
 * @param newTasks tasks that came to be with it, by the names of their owners; some may be known before
 */
record EngineStep(
        long atMillis,
        Input input,
        List<Effect> effects,
        Map<Long, DecisionPresentation> presentations,
        Map<Long, StartedPlan> plans,
        List<TaskId> newTasks) {

    /** On the engine's thread. */
    static EngineStep of(long atMillis, Input input, List<Effect> effects, EngineView view) {
        Map<Long, DecisionPresentation> presentations = new HashMap<>();
        Map<Long, StartedPlan> plans = new HashMap<>();
        List<TaskId> tasks = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened e) {
                presentations.put(e.decision().id(), DecisionPresenter.of(e.decision(), view));
            } else if (effect instanceof Effect.MissionStarted e) {
                started(e, view, plans, tasks);
            } else if (effect instanceof Effect.Fired e) {
                e.used()
                        .forEach(used ->
                                used.tasks().forEach(task -> owned(task, view).ifPresent(tasks::add)));
            }
        }
        return new EngineStep(atMillis, input, effects, presentations, plans, tasks);
    }

    private static void started(
            Effect.MissionStarted started, EngineView view, Map<Long, StartedPlan> plans, List<TaskId> tasks) {
        view.plan(started.plan()).ifPresent(plan -> {
            plans.put(started.mission(), startedPlan(started.mission(), plan, view));
            tasks.addAll(tasksOf(started.mission(), plan, view));
        });
    }

    static StartedPlan startedPlan(long mission, Plan plan, EngineView view) {
        Map<String, Value> variables = new LinkedHashMap<>();
        plan.variables()
                .forEach(variable -> view.variable(mission, variable.name())
                        .ifPresent(value -> variables.put(variable.name(), value)));
        Map<String, Value> globals = new LinkedHashMap<>();
        plan.reads().forEach(name -> view.variable(Ids.NONE, name).ifPresent(value -> globals.put(name, value)));
        return new StartedPlan(plan.title(), variables, globals);
    }

    /** The tasks that a plan gives a mission, by the names of their owners. */
    static List<TaskId> tasksOf(long mission, Plan plan, EngineView view) {
        List<TaskId> tasks = new ArrayList<>();
        plan.tasks()
                .forEach(task -> owned(new TaskId(mission, task.name()), view).ifPresent(tasks::add));
        return tasks;
    }

    private static Optional<TaskId> owned(TaskId task, EngineView view) {
        return view.namesOf(task).stream().findFirst();
    }
}
