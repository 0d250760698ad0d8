package org.sami.crw.operator;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.map.AreaVariables;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The operator's models, fed by a host, by the fleet and by handlers. They belong to the one thread of an executor; all input reaches them by one hop
 * to it, at this border and nowhere else. Neither feeding them nor any public method of a model waits (docs/threads.md).
 *
 * <p>A session makes one, adds it to its host, subscribes {@link #fleetListener} to its fleet's events, and calls {@link #look} ten times a second on
 * the fleet's thread and {@link #refresh} a few times a second on any.
 */
public final class OperatorModels implements HostListener, MessageSink {
    /** A boat is shown ten times a second at most. */
    public static final long SHOW_MILLIS = 100;

    private static final int MESSAGES_KEPT = 1000;

    private final ModelInbox inbox;
    private final DecisionQueue decisions;
    private final MessageList messages;
    private final MissionModel missions = new MissionModel();
    private final GanttModel gantt = new GanttModel();
    private final FleetModel fleet;
    private final UnreachedModel unreached;
    private final FleetStopModel fleetStop;
    private final CommandModel commands = new CommandModel();
    private final InterruptModel interrupts = new InterruptModel();
    private final OperatorLog log;
    private final OperatorSteps logged;
    private final AlarmModel alarms;
    private final HealthModel health;
    private final CommunicationModel communication = new CommunicationModel();
    private final PictureModel pictures;
    private final AllocationModel allocation = new AllocationModel();
    private final ClickModel clicks = new ClickModel();
    private final Queue<CompletableFuture<Void>> awaitShown = new ArrayDeque<>(); // for the owner's thread
    private final AreaVariables variables = new AreaVariables();
    private final MapModel map;
    private final EngineFeed engine;
    private final FleetFeed boats;
    private final StuckWatch stuck = new StuckWatch(this);
    private boolean held; // for the owner's thread

    /** Models whose clock stands still: for parts that need no ages of boats. */
    public OperatorModels(Executor owner) {
        this(owner, () -> 0);
    }

    /** Models of a session without a thread of their own: the thread that reports computes what the map needs. */
    public OperatorModels(Executor owner, LongSupplier nowMillis) {
        this(owner, nowMillis, Runnable::run, RobotKind.BOAT);
    }

    /**
     * Models with nothing in them.
     *
     * @param owner runs what it is given on one thread, one after the other: a window's event thread, or a thread of the session's
     * @param nowMillis the session's clock; from any thread
     * @param computing computes what sensors measured for the map, one after the other; never the owner's thread, where that is a
     *     window's
     * @param robots what alarms, faults and the log speak of
     */
    public OperatorModels(Executor owner, LongSupplier nowMillis, Executor computing, RobotKind robots) {
        inbox = new ModelInbox(owner, this::publish);
        decisions = new DecisionQueue(inbox::post);
        log = new OperatorLog(inbox::post, nowMillis, robots);
        logged = new OperatorSteps(log);
        messages = new MessageList(MESSAGES_KEPT, inbox::post, log, nowMillis);
        alarms = new AlarmModel(inbox::post, commands, log, missions::title, robots);
        health = new HealthModel(inbox::post, nowMillis, robots);
        unreached = new UnreachedModel(inbox::post);
        pictures = new PictureModel(inbox::post);
        fleetStop = new FleetStopModel(inbox::post, nowMillis);
        unreached.addListener(fleetStop::unreached);
        fleetStop.addListener(state -> FleetStopModel.report(state, health));
        alarms.addListener(health::alarms);
        map = new MapModel(inbox::post, commands, variables, missions::words, computing, nowMillis);
        fleet = new FleetModel(inbox::post, new FleetModel.Listener() {
            @Override
            public void seen(BoatSnapshot boat) {
                alarms.seen(boat, nowMillis.getAsLong());
                communication.seen(boat);
                map.seen(boat);
                fleetStop.seen(boat);
            }

            @Override
            public void gone(String boat) {
                communication.gone(boat);
                map.gone(boat);
                fleetStop.gone(boat);
            }
        });
        engine = new EngineFeed(this, inbox, nowMillis, logged, variables);
        boats = new FleetFeed(this, inbox, nowMillis);
    }

    /**
     * From now on the boats, their communication and the map are put together only on request or for listeners, not after each move. For models that
     * only their owner's thread reads; to be called before the first read.
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
                        gantt,
                        fleet,
                        unreached,
                        fleetStop,
                        commands,
                        interrupts,
                        alarms,
                        health, // after the alarms, which it takes up
                        pictures,
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

    /** Has a listener receive the area in which boats may go, now and at each change, on the owner's thread. From any thread. */
    public void onOperatingArea(Consumer<OperatingArea> listener) {
        engine.onOperatingArea(listener);
    }

    /** Completes, on the owner's thread, when all that happened until now is in the snapshots. From any thread. */
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

    /** Missions over time; only its owner's thread asks it. */
    public GanttModel gantt() {
        return gantt;
    }

    /** Boats. */
    public FleetModel fleet() {
        return fleet;
    }

    /** Addresses at which no boat has answered. */
    public UnreachedModel unreached() {
        return unreached;
    }

    /** Who is stopped until somebody releases it. */
    public FleetStopModel fleetStop() {
        return fleetStop;
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

    /** Every fault that lasts. */
    public HealthModel health() {
        return health;
    }

    /** The pictures that boats have taken. */
    public PictureModel pictures() {
        return pictures;
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
        stuck.take(atMillis, input, effects);
        engine.take(atMillis, input, effects, view, true);
    }

    /** As {@link #onStep}, for a step of an earlier process that is heard of again: what the operator did is in the log already. */
    public void onPastStep(long atMillis, Input input, List<Effect> effects, EngineView view) {
        stuck.take(atMillis, input, effects);
        engine.take(atMillis, input, effects, view, false);
    }

    /** Takes up the areas and places of the project, and where boats may go. As {@link #restore}; also where a state is replayed. */
    public void restoreAreas(EngineView view) {
        engine.restoreAreas(view);
    }

    /** Shows what a restored state has: missions, decisions that wait, tasks. On the engine's thread or before the host works. */
    public void restore(EngineView view, long atMillis) {
        stuck.restore(view, atMillis);
        engine.restore(view, atMillis);
    }

    /**
     * Has the engine asked what its effects do not tell: what blocks missions, what transitions keep, which buttons can be pressed. Does
     * not wait; does nothing while an earlier question is under way, or where the engine has done nothing since the last. From any thread.
     */
    public void refresh(EngineHost host, Vocabulary vocabulary) {
        engine.refresh(host, vocabulary);
    }

    /** Which missions cannot go on by themselves. For the engine's thread. */
    public StuckWatch stuck() {
        return stuck;
    }

    // ---- for a replay

    /** Has a replay tell what happened, in place of an engine's host and a fleet; for one thread of the replay's. */
    public ReplayFeed replayFeed() {
        return new ReplayFeed(this);
    }

    /**
     * Has a session elsewhere say what happens, in place of an engine's host and a fleet; for one thread of the follower's.
     *
     * @param acknowledge what is acknowledged here, for that session
     */
    public FollowFeed followFeed(FollowFeed.Acknowledgements acknowledge) {
        return new FollowFeed(this, acknowledge);
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

    /** Listeners get nothing while it is held, and everything at once afterwards. */
    void hold(boolean hold) {
        inbox.post(() -> held = hold);
    }

    /**
     * Forgets what happened. What the operator chose to see, and muted, stays, and so do decisions that wait in the state which follows. On the engine's thread.
     */
    void forget(EngineView next) {
        engine.forget(next);
        List<Decision> waiting = next.decisions();
        stuck.forget();
        inbox.post(() -> {
            variables.clear();
            decisions.retain(waiting);
            messages.clear();
            missions.clear();
            gantt.clear();
            fleet.clear();
            unreached.clear();
            fleetStop.clear();
            commands.clear();
            interrupts.show(List.of());
            alarms.clear();
            health.clear();
            pictures.clear();
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
        engine.look(view, vocabulary);
    }

    // ---- fed by handlers and by the fleet

    @Override
    public void tell(OperatorMessage message) {
        inbox.post(() -> messages.add(message));
    }

    /**
     * What is to be subscribed to the fleet's events, once; called on the fleet's thread.
     *
     * @param proxies for the fleet's thread
     */
    public Consumer<FleetEvent> fleetListener(ProxyRegistry proxies) {
        return fleetListener(proxies, SHOW_MILLIS);
    }

    /**
     * The same with another period.
     *
     * @param periodMillis how long a boat is left alone after a snapshot of it
     */
    public Consumer<FleetEvent> fleetListener(ProxyRegistry proxies, long periodMillis) {
        return boats.listener(proxies, periodMillis);
    }

    /** Looks at all boats, as ages and reasons change by themselves. To be called ten times a second on the fleet's thread. */
    public void look() {
        boats.look();
    }
}
