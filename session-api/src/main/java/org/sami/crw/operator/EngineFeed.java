package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.area.AvoidedAreas;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.markup.MarkedEvent;
import org.sami.crw.operator.MissionModel.StartedPlan;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.map.AreaVariables;
import org.sami.crw.task.TaskQueue;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Tells the models what the engine did: its steps, a state that was restored, and what it says when it is asked. What must be read of the
 * engine is read on its thread; all of it reaches the models by one hop.
 */
final class EngineFeed {
    private final OperatorModels models;
    private final ModelInbox inbox;
    private final LongSupplier nowMillis;
    private final OperatorSteps logged;
    private final AreaVariables variables;
    private final RunningPlans plans = new RunningPlans(); // for the engine's thread
    private final AvoidedAreas avoided = new AvoidedAreas(); // likewise
    private final AtomicLong steps = new AtomicLong();
    private final AtomicLong stepsLookedAt = new AtomicLong();
    private final AtomicBoolean looking = new AtomicBoolean();
    private Consumer<OperatingArea> areas = area -> {}; // this and the next: for the owner's thread
    private OperatingArea area = OperatingArea.OPEN;

    /**
     * Tells nothing yet.
     *
     * @param variables on which the models of areas are built
     */
    EngineFeed(
            OperatorModels models,
            ModelInbox inbox,
            LongSupplier nowMillis,
            OperatorSteps logged,
            AreaVariables variables) {
        this.models = models;
        this.inbox = inbox;
        this.nowMillis = nowMillis;
        this.logged = logged;
        this.variables = variables;
    }

    /**
     * Tells of a step. On the engine's thread.
     *
     * @param isNew whether the operator's log does not have it yet
     */
    void take(long atMillis, Input input, List<Effect> effects, EngineView view, boolean isNew) {
        steps.incrementAndGet();
        if (!effects.isEmpty() || !(input instanceof Input.Received)) {
            EngineStep step = EngineStep.of(atMillis, input, effects, view, plans, avoided);
            inbox.post(() -> {
                logged.apply(input, effects, isNew);
                apply(step);
            });
        }
    }

    private void apply(EngineStep step) {
        models.clicks().apply(step.input(), step.effects());
        step.plans().forEach((mission, plan) -> variables.mission(mission, plan.variables()));
        step.globals().ifPresent(variables::project);
        boolean moved = variables.apply(step.input(), step.effects());
        if (moved || step.globals().isPresent()) {
            operatingAreaChanged();
        }
        step.avoided().ifPresent(areas -> models.alarms().setAvoided(areas, nowMillis.getAsLong()));
        models.communication().apply(step);
        models.allocation().apply(step.input(), step.effects(), step.newTasks());
        for (Effect effect : step.effects()) {
            models.missions().apply(effect, step.plans(), step.atMillis());
            if (effect instanceof Effect.DecisionOpened opened) {
                long decision = opened.decision().id();
                open(
                        Objects.requireNonNull(
                                step.presentations().get(decision), () -> "decision " + decision + " is not presented"),
                        step.atMillis());
            } else if (effect instanceof Effect.DecisionClosed closed) {
                models.decisions().close(closed.decision(), closed.answer(), closed.by());
            } else if (effect instanceof Effect.DecisionHeld held) {
                models.decisions().hold(held.decision());
            } else {
                EngineMessages.of(effect, step.atMillis()).ifPresent(models.messages()::add);
            }
        }
        models.gantt().apply(step);
        models.map().apply(step); // it names missions that the step has started
    }

    private void operatingAreaChanged() {
        OperatingArea now = variables.operatingArea();
        models.alarms().setArea(now, nowMillis.getAsLong());
        models.map().refresh();
        if (!now.equals(area)) {
            area = now;
            areas.accept(now);
        }
    }

    /** Has a listener receive the operating area at each change, on the owner's thread. From any thread. */
    void onOperatingArea(Consumer<OperatingArea> listener) {
        inbox.post(() -> {
            areas = listener;
            listener.accept(area);
        });
    }

    private void open(DecisionPresentation presentation, long atMillis) {
        models.decisions().open(new PendingDecision(presentation, atMillis, false));
    }

    /** Takes up the areas and places of the project, and where boats may go. As {@link #restore}. */
    void restoreAreas(EngineView view) {
        Map<String, Value> globals = view.globals();
        Optional<Value> fence = view.memory(Ids.NONE, OperatingArea.MEMORY);
        inbox.post(() -> {
            variables.project(globals);
            variables.remembered(fence);
            operatingAreaChanged();
        });
    }

    /** Shows what a restored state has: missions, decisions that wait, tasks. On the engine's thread or before the host works. */
    void restore(EngineView view, long atMillis) {
        List<Effect> marking = view.markingAsEffects();
        List<DecisionPresentation> open = new ArrayList<>();
        view.decisions().forEach(decision -> open.add(DecisionPresenter.of(decision, view)));
        plans.restore(view);
        Map<Long, List<GeoArea>> areas = avoided.restore(view);
        Map<Long, StartedPlan> started = new HashMap<>();
        Map<Long, MissionModel.Earlier> earlier = new HashMap<>();
        List<TaskId> tasks = new ArrayList<>();
        view.missions().forEach(mission -> {
            earlier.put(mission.id(), new MissionModel.Earlier(mission.startedAtMillis(), mission.firings()));
            Optional<Plan> plan = plans.of(mission.id());
            plan.ifPresent(one -> started.put(mission.id(), EngineStep.startedPlan(mission.id(), one, view)));
            plan.ifPresent(one -> tasks.addAll(EngineStep.tasksOf(mission.id(), one, view)));
        });
        Set<TaskId> complete = new HashSet<>();
        tasks.stream().filter(task -> TaskQueues.isComplete(task, view)).forEach(complete::add);
        Map<TaskId, String> robots = view.allocation();
        Map<String, TaskQueue> queues = TaskQueues.remembered(view);
        List<Activation> activations = view.openActivations();
        List<MarkedEvent> marked = activations.stream()
                .filter(activation -> !activation.markups().isEmpty())
                .map(MarkedEvent::of)
                .toList();
        inbox.post(() -> {
            started.forEach((mission, plan) -> variables.mission(mission, plan.variables()));
            models.communication().restore(marked, atMillis);
            logged.restore(open.stream().map(DecisionPresentation::decision).toList());
            models.missions().restore(marking, started, earlier, atMillis);
            models.gantt().restore(marking, activations, started, earlier, atMillis);
            models.map().restore(marked);
            models.alarms().setAvoided(areas, atMillis);
            models.allocation().restore(tasks, robots, complete, queues);
            open.forEach(presentation -> open(presentation, atMillis));
        });
    }

    /**
     * Has the engine asked what its effects do not tell: what blocks missions, what transitions keep, which buttons can be pressed. Does
     * not wait; does nothing while an earlier question is under way, or where the engine has done nothing since the last. From any thread.
     */
    void refresh(EngineHost host, Vocabulary vocabulary) {
        long now = steps.get();
        if (now == stepsLookedAt.get() || !looking.compareAndSet(false, true)) {
            return;
        }
        CompletableFuture<EngineSnapshot> look = host.query(view -> EngineSnapshot.at(view, vocabulary));
        look.whenComplete((told, fault) -> {
                    looking.set(false);
                    if (fault == null) {
                        stepsLookedAt.set(now);
                        looked(told);
                    }
                })
                .exceptionally(stopped -> null); // the host takes no more questions: what was known stays
    }

    /** Shows what an engine says when it is asked. On the engine's thread. */
    void look(EngineView view, Vocabulary vocabulary) {
        looked(EngineSnapshot.at(view, vocabulary));
    }

    private void looked(EngineSnapshot told) {
        inbox.post(() -> {
            models.missions().details(told.details());
            models.interrupts().show(told.buttons());
        });
    }

    /** Forgets what happened, in this feed. On the engine's thread. */
    void forget(EngineView next) {
        plans.restore(next);
        avoided.restore(next);
    }
}
