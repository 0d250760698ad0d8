package org.sami.crw.session;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.FleetEvents;
import org.sami.crw.fleet.FleetWants;
import org.sami.crw.handler.CrwDomain;
import org.sami.crw.handler.planning.ServiceThreads;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/** The parts of a session, put together for its runtime. */
final class SessionParts {
    /** On the caller's one thread nobody waits for a listener but the caller. */
    private static final long NEVER_SLOW_MILLIS = Long.MAX_VALUE;

    private static final long SLOW_MILLIS = 50;
    private static final long LOOK_MS = 1000;
    private static final long STUCK_MS = 1000;
    private static final int SHOWN_BEFORE_REFRESH = 3;

    /** In simulated time ten looks a second would take longer than all else, and nobody watches that closely. */
    private static final long ONE_THREAD_SHOW_MS = 10_000;

    final Engine engine;
    final Scheduler scheduler;
    final Executor executor;
    final Executor front;
    final Replies replies;
    final EngineHost host;
    final FleetConnector connector;
    final FleetHistory history = new FleetHistory();
    final SessionTelemetry telemetry;
    final OperatorModels models;
    final SessionMessages messages;
    final FleetEvents events;
    final FleetListener boats;
    final BoatMonitor monitor;
    private final LinkWatch linkWatch;
    private final UnreachedWatch unreachedWatch;
    final PoseLog poses;
    final BoatLog boatLog;
    final PostedInputs posted;
    final Operators operators = new Operators();
    final CrwDomain domain;
    final Optional<RememberedBoats> remembered;
    final ProjectFiles projects;
    final Executor files;
    final SettingReplies settings;

    private final Vocabulary vocabulary;
    private final SessionJournal journal;
    private final Optional<RealTimeLoop> loop;
    private final Optional<ServiceThreads> services;
    private final Optional<ExecutorService> ownFront;
    private final Optional<ExecutorService> ownFiles;
    private final long showMillis;
    private final long shownBeforeStuck;
    private final Optional<ExecutorService> forMap;

    /** Computes what is only to be drawn. */
    final Executor drawing;

    private final CompletableFuture<Void> ended = new CompletableFuture<>();
    private volatile boolean halted;
    private volatile boolean listensNoLonger;
    private boolean replayed; // before it begins
    private long shown; // for the engine's thread

    /** Guards the threads; for the runtime of a window or a console as well. */
    final ThreadGuard guard = new ThreadGuard(this::report, this::stop);

    /** Empty where everything is one thread of the caller's, who sees what it throws. */
    final Optional<SessionMonitor> sessionMonitor;

    final SessionFaults faults;

    SessionParts(SessionSetup setup) throws IOException {
        vocabulary = setup.vocabulary();
        journal = setup.journal();
        engine = new Engine(setup.vocabulary(), setup.project());
        if (setup.runtime() instanceof SessionRuntime.RealTime real) {
            loop = Optional.of(new RealTimeLoop(journal.cameToMillis(), real.clock()));
            scheduler = loop.get();
            executor = loop.get();
            services = Optional.of(new ServiceThreads(ServiceThreads.STANDARD_LIMIT_MILLIS, guard::lost));
            ownFront = real.front().isPresent() ? Optional.empty() : Optional.of(newThread("session", guard));
            front = real.front().orElseGet(ownFront::get);
        } else {
            SessionRuntime.OneThread one = (SessionRuntime.OneThread) setup.runtime();
            loop = Optional.empty();
            scheduler = one.clock();
            executor = one.executor();
            services = Optional.empty();
            ownFront = Optional.empty();
            front = one.executor();
        }
        shownBeforeStuck = loop.isPresent() ? STUCK_MS / OperatorModels.SHOW_MILLIS : 1;
        showMillis = loop.isPresent() ? OperatorModels.SHOW_MILLIS : ONE_THREAD_SHOW_MS;
        long slowMillis = loop.isPresent() ? SLOW_MILLIS : NEVER_SLOW_MILLIS;
        ScheduledHostClock clock = new ScheduledHostClock(scheduler);
        host = EngineHost.builder(engine, journal.restore(engine))
                .journal(journal.inputs())
                .clock(clock)
                .executor(executor)
                .slowListenerMillis(slowMillis)
                .journalRetryMillis(setup.onFault().patienceMillis())
                .build();
        replies = new Replies(front);
        projects = new ProjectFiles(vocabulary);
        ownFiles = loop.map(real -> newThread("files", this::lost));
        files = ownFiles.<Executor>map(own -> own).orElse(executor);
        posted = new PostedInputs(host, replies);
        telemetry = new SessionTelemetry(journal, scheduler::nowMs);
        forMap = loop.map(real -> newThread("map", this::lost));
        drawing = forMap.<Executor>map(map -> map).orElse(Runnable::run);
        models = new OperatorModels(front, scheduler::nowMs, drawing);
        if (loop.isEmpty()) {
            models.showBoatsWhenAsked();
        }
        messages = new SessionMessages(telemetry, models);
        remembered = loop.map(real -> new RememberedBoats(host));
        connector = connector(setup.runtime());
        events = new FleetEvents(slowMillis);
        boats = new FleetListener(events, history, telemetry, messages, remembered, scheduler::nowMs, guard);
        monitor = new BoatMonitor(
                history, telemetry, messages, models.missions()::title, loop.isPresent(), scheduler::nowMs);
        linkWatch = new LinkWatch(models.health());
        unreachedWatch = new UnreachedWatch(models, messages, remembered);
        poses = new PoseLog(history, telemetry);
        boatLog = new BoatLog(
                connector::boats, setup.services().error(), models.missions()::title, telemetry, scheduler::nowMs);
        if (journal.keepsTelemetry()) {
            events.subscribe(boatLog::take);
        }
        events.subscribe(this::watchLinks);
        settings = new SettingReplies(replies);
        events.subscribe(settings::happened);
        connector.open(boats);
        if (loop.isPresent()) { // a run in process is resumed by running its world again, with all that was done in it
            List<TelemetryRow> earlier = journal.earlier();
            models.log().restore(OperatorLogRows.read(earlier));
            MapHistory.restore(earlier, models.map());
            models.log()
                    .keepWith(entry -> connector
                            .executor()
                            .execute(() -> telemetry.add(
                                    entry.atMillis(), "", OperatorLogRows.KIND, OperatorLogRows.json(entry))));
        }
        domain = services.map(threads -> CrwDomain.installInRealTime(
                        host,
                        connector.boats(),
                        connector.executor(),
                        messages,
                        setup.services(),
                        connector,
                        events,
                        threads))
                .orElseGet(() -> CrwDomain.install(
                        host, connector.boats(), connector.executor(), messages, setup.services(), connector, events));
        host.addListener(operators);
        host.addListener(models);
        host.addListener(posted);
        sessionMonitor = loop.map(real ->
                new SessionMonitor(host, journal, connector, models.health(), messages, setup.onFault(), guard));
        faults = new SessionFaults(
                host,
                guard,
                sessionMonitor.map(SessionMonitor::engine),
                setup.onFault().boats());
        events.subscribe(models.fleetListener(connector.boats(), showMillis));
    }

    private FleetConnector connector(SessionRuntime runtime) {
        if (runtime instanceof SessionRuntime.OneThread one) {
            return one.fleet();
        }
        SessionRuntime.RealTime real = (SessionRuntime.RealTime) runtime;
        Optional<SimulatedBoats> simulated =
                real.simulatedBoats().map(boats -> new RememberedSimulation(boats, remembered.orElseThrow()));
        return new TcpFleet(real.links(), real.clock(), simulated);
    }

    private void report(HealthFault fault) {
        models.health().report(fault);
    }

    private void stop(String reason) {
        host.fail(reason);
    }

    private void lost(Thread thread, Throwable fault) {
        guard.lost(thread.getName(), fault);
    }

    private static ExecutorService newThread(String name, Thread.UncaughtExceptionHandler guard) {
        return Executors.newSingleThreadExecutor(work -> {
            Thread thread = new Thread(work, name);
            thread.setDaemon(true);
            thread.setUncaughtExceptionHandler(guard);
            return thread;
        });
    }

    /** Where earlier processes saw each boat last, by its name. */
    Map<String, GeoPoint> lastPositions() throws IOException {
        Map<String, GeoPoint> last = new HashMap<>();
        SessionTelemetry.read(journal.earlier(), new SessionTelemetry.Reader() {
            @Override
            public void pose(long atMillis, String boat, FleetHistory.Told told, double distanceM) {
                last.put(boat, told.position());
            }
        });
        return last;
    }

    void begin() {
        host.ask(view -> {
            operators.restore(view, scheduler.nowMs());
            models.restoreAreas(view);
            if (!replayed) { // else the models have heard it
                models.restore(view, scheduler.nowMs());
            }
            return null;
        });
        host.resume();
        keepLookingAfterBoats();
        keepShowing();
        loop.ifPresent(this::startEngine);
    }

    /** Lets a listener, the models and after them the operators hear of the past. */
    void replay(HostListener listener) throws IOException {
        replayed = true;
        journal.replay(engine, (index, atMillis, input, effects, view) -> {
            listener.onStep(index, atMillis, input, effects, view);
            models.onPastStep(atMillis, input, effects, view);
            operators.onStep(index, atMillis, input, effects, view);
        });
    }

    /** Ages and reasons change by themselves. */
    private void keepShowing() {
        try {
            connector.executor().execute(models::look);
            if (++shown % SHOWN_BEFORE_REFRESH == 0) {
                models.refresh(host, vocabulary);
            }
            if (shown % shownBeforeStuck == 0) {
                lookForStuckMissions();
            }
        } finally {
            scheduler.after(showMillis, this::keepShowing);
        }
    }

    private void keepLookingAfterBoats() {
        try {
            connector.executor().execute(() -> {
                monitor.look(connector.boats());
                linkWatch.look(scheduler.nowMs());
                unreachedWatch.look(connector.linkReports(), scheduler.nowMs());
                if (journal.keepsTelemetry()) {
                    boatLog.look();
                    poses.look(scheduler.nowMs());
                }
            });
            sessionMonitor.ifPresent(one -> one.look(scheduler.nowMs()));
        } finally {
            scheduler.after(LOOK_MS, this::keepLookingAfterBoats);
        }
    }

    private void watchLinks(FleetEvent event) {
        if (!listensNoLonger) {
            linkWatch.take(event, scheduler.nowMs());
        }
    }

    /** After what missions asked before has reached the proxies. */
    private void lookForStuckMissions() {
        connector.executor().execute(() -> {
            FleetWants wants = domain.wants();
            executor.execute(() -> host.ask(view -> {
                models.stuck().look(view, wants, scheduler.nowMs());
                return null;
            }));
        });
    }

    void whoIsWanted(Consumer<Set<String>> then) {
        connector.executor().execute(() -> {
            Set<String> wanted = connector.boats().all().stream()
                    .filter(boat -> !boat.isAtRest())
                    .map(BoatProxy::boatId)
                    .collect(Collectors.toSet());
            executor.execute(() -> then.accept(wanted));
        });
    }

    private void startEngine(RealTimeLoop real) {
        Thread thread = new Thread(() -> runEngine(real), "engine");
        thread.setDaemon(true);
        thread.start();
    }

    private void runEngine(RealTimeLoop real) {
        try {
            real.run(() -> halted, fault -> guard.caught("engine", fault));
        } finally {
            ended.complete(null);
        }
    }

    CompletionStage<Void> halt() {
        halted = true;
        return ended;
    }

    /** Asks the proxies and waits; not for the fleet's thread. */
    <T> T onFleet(Function<ProxyRegistry, T> question) {
        return CompletableFuture.supplyAsync(() -> question.apply(connector.boats()), connector.executor())
                .join();
    }

    /** What becomes of links now is the session's own doing. */
    void listenNoLonger() {
        listensNoLonger = true;
        boats.close();
        boatLog.close();
        messages.close();
    }

    void close() throws IOException {
        listenNoLonger();
        halted = true;
        sessionMonitor.ifPresent(SessionMonitor::close);
        services.ifPresent(ServiceThreads::close);
        onFleet(known -> known.boatIds()); // what the operator did last has been written down
        connector.close();
        telemetry.flush();
        host.close();
        replies.close();
        ownFront.ifPresent(ExecutorService::shutdown);
        ownFiles.ifPresent(ExecutorService::shutdown);
        forMap.ifPresent(ExecutorService::shutdown);
        journal.close();
    }
}
