package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.area.AvoidedAreas;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.markup.MarkedEvent;
import org.sami.crw.operator.MissionModel.StartedPlan;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * One step of the engine as models need it, with everything that must be read on the engine's thread; immutable.
 *
 * @param presentations decisions that it opened, presented
 * @param plans plans of missions that it started
 * @param newTasks tasks that it made, by the names of their owners; some may be known already
 * @param marked output and input events with markup that were sent and used
 * @param globals the project's variables, where the project changed
 * @param avoided areas to avoid, by mission, where they changed
 */
record EngineStep(
        long atMillis,
        Input input,
        List<Effect> effects,
        Map<Long, DecisionPresentation> presentations,
        Map<Long, StartedPlan> plans,
        List<TaskId> newTasks,
        List<MarkedEvent> marked,
        Optional<Map<String, Value>> globals,
        Optional<Map<Long, List<GeoArea>>> avoided) {

    /** On the engine's thread. */
    static EngineStep of(
            long atMillis,
            Input input,
            List<Effect> effects,
            EngineView view,
            RunningPlans running,
            AvoidedAreas avoided) {
        running.before(effects, view);
        Map<Long, DecisionPresentation> presentations = new HashMap<>();
        Map<Long, StartedPlan> plans = new HashMap<>();
        List<TaskId> tasks = new ArrayList<>();
        List<MarkedEvent> marked = new ArrayList<>();
        Optional<Map<String, Value>> globals = Optional.empty();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated e
                    && !e.activation().markups().isEmpty()) {
                marked.add(MarkedEvent.of(e.activation()));
            } else if (effect instanceof Effect.DecisionOpened e) {
                presentations.put(e.decision().id(), DecisionPresenter.of(e.decision(), view));
            } else if (effect instanceof Effect.MissionStarted e) {
                running.of(e.mission()).ifPresent(plan -> {
                    plans.put(e.mission(), startedPlan(e.mission(), plan, view));
                    tasks.addAll(tasksOf(e.mission(), plan, view));
                });
            } else if (effect instanceof Effect.ProjectLoaded) {
                globals = Optional.of(view.globals());
            } else if (effect instanceof Effect.Fired e) {
                marked.addAll(running.received(e));
                e.used()
                        .forEach(used ->
                                used.tasks().forEach(task -> owned(task, view).ifPresent(tasks::add)));
            }
        }
        running.after(effects);
        return new EngineStep(
                atMillis, input, effects, presentations, plans, tasks, marked, globals, avoided.after(effects, view));
    }

    static StartedPlan startedPlan(long mission, Plan plan, EngineView view) {
        Map<String, Value> variables = new LinkedHashMap<>();
        plan.variables()
                .forEach(variable -> view.variable(mission, variable.name())
                        .ifPresent(value -> variables.put(variable.name(), value)));
        Map<String, Value> globals = new LinkedHashMap<>();
        plan.reads().forEach(name -> view.variable(Ids.NONE, name).ifPresent(value -> globals.put(name, value)));
        return new StartedPlan(
                plan.title(),
                variables,
                globals,
                Optional.of(new StartedPlan.Drawn(plan, PhaseChart.of(plan, view.vocabulary()))));
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
