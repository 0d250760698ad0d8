package org.sami.crw.operator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.markup.MarkedEvent;
import org.sami.crw.operator.MissionModel.StartedPlan;
import org.sami.crw.operator.area.AreaVariables;
import org.sami.crw.operator.area.AvoidedAreas;
import org.sami.crw.operator.area.OperatingArea;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.message.MessageSink;
import org.sami.crw.operator.message.OperatorMessage;
import org.sami.crw.operator.message.PendingDecision;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.task.TaskQueue;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What lies before the operator, fed by a host, by the fleet and by handlers. The models belong to the one thread of an executor;
 * everything reaches them by one hop to it, at this border and nowhere else. Whoever feeds them never waits, and no public method of a
 * model does (docs/threads.md).
 *
 * <p>A session makes one, adds it to its host, subscribes {@link #fleetListener} to its fleet's events, and calls {@link #look} ten times
 * a second on the fleet's thread and {@link #refresh} a few times a second on any.
 */
public final class OperatorModels implements HostListener, MessageSink {
    /** A boat is shown ten times a second at most. */
    public static final long SHOW_MILLIS = 100;

    private static final int MESSAGES_KEPT = 1000;

    private final ModelInbox inbox;
    private final LongSupplier nowMillis;
    private final DecisionQueue decisions;
    private final MessageList messages;
    private final MissionModel missions = new MissionModel();
    private final FleetModel fleet;
    private final CommandModel commands = new CommandModel();
    private final InterruptModel interrupts = new InterruptModel();
    private final OperatorLog log;
    private final OperatorSteps logged;
    private final AlarmModel alarms;
    private final CommunicationModel communication = new CommunicationModel();
    private final AllocationModel allocation = new AllocationModel();
    private final ClickModel clicks = new ClickModel();
    private final Queue<CompletableFuture<Void>> awaitShown = new ArrayDeque<>(); // for the owner's thread
    private final AreaVariables variables = new AreaVariables();
    private final MapModel map;
    private final RunningPlans plans = new RunningPlans(); // for the engine's thread
    private final AvoidedAreas avoided = new AvoidedAreas(); // likewise
    private boolean held; // for the owner's thread
    private final AtomicLong steps = new AtomicLong();
    private final AtomicLong stepsLookedAt = new AtomicLong();
    private final AtomicBoolean looking = new AtomicBoolean();
    private final AtomicBoolean ticking = new AtomicBoolean();
    private volatile Optional<FleetSampler> sampler = Optional.empty();

    /** Models whose clock stands still: for parts that need no ages of boats. */
    public OperatorModels(Executor owner) {
        this(owner, () -> 0);
    }

    /** Models of a session without a thread to spare: what the map needs is computed by whoever tells of it. */
    public OperatorModels(Executor owner, LongSupplier nowMillis) {
        this(owner, nowMillis, Runnable::run);
    }

    /**
     * Models with nothing in them.
     *
     * @param owner runs what it is given on one thread, one after the other: a window's event thread, or a thread of the session's
     * @param nowMillis the session's clock; from any thread
     * @param computing computes what sensors measured for the map, one after the other; never the owner's thread, where that is a
     *     window's
     */
    public OperatorModels(Executor owner, LongSupplier nowMillis, Executor computing) {
        this.nowMillis = nowMillis;
        inbox = new ModelInbox(owner, this::publish);
        decisions = new DecisionQueue(inbox::post);
        log = new OperatorLog(inbox::post, nowMillis);
        logged = new OperatorSteps(log);
        messages = new MessageList(MESSAGES_KEPT, inbox::post, log, nowMillis);
        alarms = new AlarmModel(inbox::post, commands, log, missions::title);
        map = new MapModel(inbox::post, commands, variables, missions::words, computing, nowMillis);
        fleet = new FleetModel(inbox::post, new FleetModel.Listener() {
            @Override
            public void seen(BoatSnapshot boat) {
                alarms.seen(boat, nowMillis.getAsLong());
                communication.seen(boat);
                map.seen(boat);
            }

            @Override
            public void gone(String boat) {
                communication.gone(boat);
                map.gone(boat);
            }
        });
    }

    /**
     * From now on what follows each move of boats is only put together when somebody asks for it, or listens: the boats, their communication, the map. Only
     * where nobody but the owner's thread asks; to be called before anybody does.
     */
    public void showBoatsWhenAsked() {
        fleet.takeWhenAsked();
        communication.takeWhenAsked();
        map.takeWhenAsked();
    }

    private void publish() {
        if (held) {
            return;
        }
        List.of(
                        decisions,
                        messages,
                        missions,
                        fleet,
                        commands,
                        interrupts,
                        alarms,
                        allocation,
                        clicks,
                        communication,
                        map,
                        log)
                .forEach(Model::publish);
        for (CompletableFuture<Void> one = awaitShown.poll(); one != null; one = awaitShown.poll()) {
            one.complete(null);
        }
    }

    /** Completes, on the owner's thread, when all that was told until now is in the snapshots. From any thread. */
    public CompletionStage<Void> shown() {
        CompletableFuture<Void> shown = new CompletableFuture<>();
        inbox.post(() -> awaitShown.add(shown));
        return shown;
    }

    /** Decisions that wait. */
    public DecisionQueue decisions() {
        return decisions;
    }

    /** Messages to the operator. */
    public MessageList messages() {
        return messages;
    }

    /** Missions and sub-missions. */
    public MissionModel missions() {
        return missions;
    }

    /** Boats. */
    public FleetModel fleet() {
        return fleet;
    }

    /** What missions have boats do. */
    public CommandModel commands() {
        return commands;
    }

    /** Buttons of running missions. */
    public InterruptModel interrupts() {
        return interrupts;
    }

    /** What is wrong. */
    public AlarmModel alarms() {
        return alarms;
    }

    /** Who has which tasks. */
    public AllocationModel allocation() {
        return allocation;
    }

    /** The operator's clicks. */
    public ClickModel clicks() {
        return clicks;
    }

    /** How boats stand in their missions, and their links. */
    public CommunicationModel communication() {
        return communication;
    }

    /** What operators did. */
    public OperatorLog log() {
        return log;
    }

    /** What is to be drawn on the map. */
    public MapModel map() {
        return map;
    }

    // ---- fed by the engine

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        take(atMillis, input, effects, view, true);
    }

    /** As {@link #onStep}, for a step of an earlier process that is heard of again: what the operator did is in the log already. */
    public void onPastStep(long atMillis, Input input, List<Effect> effects, EngineView view) {
        take(atMillis, input, effects, view, false);
    }

    private void take(long atMillis, Input input, List<Effect> effects, EngineView view, boolean isNew) {
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
        clicks.apply(step.input(), step.effects());
        step.plans().forEach((mission, plan) -> variables.mission(mission, plan.variables()));
        step.globals().ifPresent(variables::project);
        boolean moved = variables.apply(step.input(), step.effects());
        if (moved || step.globals().isPresent()) {
            operatingAreaChanged();
        }
        step.avoided().ifPresent(areas -> alarms.setAvoided(areas, nowMillis.getAsLong()));
        communication.apply(step);
        allocation.apply(step.input(), step.effects(), step.newTasks());
        for (Effect effect : step.effects()) {
            missions.apply(effect, step.plans(), step.atMillis());
            if (effect instanceof Effect.DecisionOpened opened) {
                open(step.presentations().get(opened.decision().id()), step.atMillis());
            } else if (effect instanceof Effect.DecisionClosed closed) {
                decisions.close(closed.decision(), closed.answer(), closed.by());
            } else if (effect instanceof Effect.DecisionHeld held) {
                decisions.hold(held.decision());
            } else {
                EngineMessages.of(effect, step.atMillis()).ifPresent(messages::add);
            }
        }
        map.apply(step); // it names missions that the step has started
    }

    private void operatingAreaChanged() {
        alarms.setArea(variables.operatingArea(), nowMillis.getAsLong());
        map.refresh();
    }

    private void open(DecisionPresentation presentation, long atMillis) {
        decisions.open(new PendingDecision(presentation, atMillis, false));
    }

    /** Takes up the areas and places of the project, and where boats may go. As {@link #restore}; also where a state is replayed. */
    public void restoreAreas(EngineView view) {
        Map<String, Value> globals = view.globals();
        Optional<Value> fence = view.memory(Ids.NONE, OperatingArea.MEMORY);
        inbox.post(() -> {
            variables.project(globals);
            variables.remembered(fence);
            operatingAreaChanged();
        });
    }

    /** Shows what a restored state has: missions, decisions that wait, tasks. On the engine's thread or before the host works. */
    public void restore(EngineView view, long atMillis) {
        List<Effect> marking = view.markingAsEffects();
        List<DecisionPresentation> open = new ArrayList<>();
        view.decisions().forEach(decision -> open.add(DecisionPresenter.of(decision, view)));
        plans.restore(view);
        Map<Long, List<GeoArea>> areas = avoided.restore(view);
        Map<Long, StartedPlan> started = new HashMap<>();
        List<TaskId> tasks = new ArrayList<>();
        view.missions().forEach(mission -> {
            Optional<Plan> plan = plans.of(mission.id());
            plan.ifPresent(one -> started.put(mission.id(), EngineStep.startedPlan(mission.id(), one, view)));
            plan.ifPresent(one -> tasks.addAll(EngineStep.tasksOf(mission.id(), one, view)));
        });
        Set<TaskId> complete = new HashSet<>();
        tasks.stream().filter(task -> TaskQueues.isComplete(task, view)).forEach(complete::add);
        Map<TaskId, String> robots = view.allocation();
        Map<String, TaskQueue> queues = TaskQueues.remembered(view);
        List<MarkedEvent> marked = view.openActivations().stream()
                .filter(activation -> !activation.markups().isEmpty())
                .map(MarkedEvent::of)
                .toList();
        inbox.post(() -> {
            started.forEach((mission, plan) -> variables.mission(mission, plan.variables()));
            communication.restore(marked, atMillis);
            logged.restore(open.stream().map(DecisionPresentation::decision).toList());
            missions.restore(marking, started, atMillis);
            map.restore(marked);
            alarms.setAvoided(areas, atMillis);
            allocation.restore(tasks, robots, complete, queues);
            open.forEach(presentation -> open(presentation, atMillis));
        });
    }

    /**
     * Has the engine asked what its effects do not tell: what blocks missions, what transitions keep, which buttons can be pressed. Does
     * not wait; does nothing while an earlier question is under way, or where the engine has done nothing since the last. From any thread.
     */
    public void refresh(EngineHost host, Vocabulary vocabulary) {
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

    private void looked(EngineSnapshot told) {
        inbox.post(() -> {
            missions.details(told.details());
            interrupts.show(told.buttons());
        });
    }

    // ---- for a replay

    /** Has a replay tell what happened, in place of an engine's host and a fleet; for one thread of the replay's. */
    public ReplayFeed replayFeed() {
        return new ReplayFeed(this);
    }

    void post(Runnable change) {
        inbox.post(change);
    }

    /** A boat is still as it was: only ages change. On the owner's thread. */
    void stillSeen(BoatSnapshot boat) {
        fleet.refresh(boat);
        map.seen(boat);
        communication.seen(boat);
    }

    /** Listeners are told of nothing while it is held; afterwards of all at once. */
    void hold(boolean hold) {
        inbox.post(() -> held = hold);
    }

    /** Forgets what happened. What the operator chose to see, and muted, stays. On the engine's thread. */
    void forget(EngineView empty) {
        plans.restore(empty);
        avoided.restore(empty);
        inbox.post(() -> {
            variables.clear();
            decisions.clear();
            messages.clear();
            missions.clear();
            fleet.clear();
            commands.clear();
            interrupts.show(List.of());
            alarms.clear();
            allocation.clear();
            clicks.clear();
            map.clear();
            communication.clear();
            log.clear();
            logged.clear();
        });
    }

    /** Shows what an engine says when it is asked. On the engine's thread. */
    void look(EngineView view, Vocabulary vocabulary) {
        looked(EngineSnapshot.at(view, vocabulary));
    }

    // ---- fed by handlers and by the fleet

    @Override
    public void tell(OperatorMessage message) {
        inbox.post(() -> messages.add(message));
    }

    /**
     * What is to be subscribed to the fleet's events, once; called on the fleet's thread.
     *
     * @param boats the proxies, for the fleet's thread
     */
    public Consumer<FleetEvent> fleetListener(ProxyRegistry boats) {
        return fleetListener(boats, SHOW_MILLIS);
    }

    /**
     * The same with another period.
     *
     * @param periodMillis how long a boat is left alone after a snapshot of it
     */
    public Consumer<FleetEvent> fleetListener(ProxyRegistry boats, long periodMillis) {
        FleetSampler made = new FleetSampler(boats, missions::title, nowMillis, periodMillis, fleet::seen);
        sampler = Optional.of(made);
        alarms.sampledEvery(periodMillis);
        return event -> {
            made.happened(event);
            if (event instanceof FleetEvent.Measured measured) {
                map.measured(measured);
            }
            if (CommandModel.concerns(event)
                    || event instanceof FleetEvent.LinkAlarmed
                    || event instanceof FleetEvent.Moved) {
                long at = nowMillis.getAsLong();
                inbox.post(() -> {
                    if (CommandModel.concerns(event)) {
                        commands.apply(event, at);
                        map.refresh();
                    }
                    alarms.apply(event, at);
                });
            }
        };
    }

    /** Looks at all boats, as ages and reasons change by themselves. To be called ten times a second on the fleet's thread. */
    public void look() {
        sampler.ifPresent(FleetSampler::look);
        long now = nowMillis.getAsLong();
        map.look(now);
        if (ticking.compareAndSet(false, true)) {
            inbox.post(() -> {
                ticking.set(false);
                map.tick(now);
                messages.tick(now);
                alarms.tick(now);
            });
        }
    }
}
