package org.sami.crw.sim.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.OperatorDefaults;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionJournal;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.report.LinkResult;
import org.sami.crw.sim.report.LinkResult.Uploads;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.record.ReportEnd;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.record.RunRecords;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.world.SimulatedBoatConnector;
import org.sami.crw.sim.run.world.SimulatedWater;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.value.Value;

/**
 * One mission on simulated boats, all in one thread: engine, handlers, links, boats and operator; boats of large fleets are ticked by helpers as well
 * (docs/decisions, 0315). A function of its plan and its settings; of the speed and of helpers depends only how long it takes. Used once, by one thread.
 */
public final class InProcessRun {
    private static final String LINK = "in-process";
    private static final long LOOK_MILLIS = 200;
    private static final long TRACK_MILLIS = 1000;
    private static final long MARK_MILLIS = 10_000;
    private static final long STALL_MILLIS = 1000;
    private static final long MARK_ENTRIES = 10;
    private static final long JOIN_MILLIS = 30_000;
    private static final int BOATS_FOR_HELPERS = 50; // fewer are ticked sooner than a helper has heard of it
    private static final int MOST_HELPERS = 3;

    private final RunSettings settings;
    private final RunJournal journal;
    private final LoopExecutor executor = new LoopExecutor();
    private final VirtualClock clock = new VirtualClock();
    private final SimulatedWater water;
    private final SimulatedOperatorDriver operator;
    private final Session session;
    private final RunRecords records;
    private final RunLifecycle lifecycle;
    private boolean catchingUp = true;
    private long markedIndex;
    private boolean endsWhenStuck = true;
    private int helpers;

    /**
     * Puts the world together; nothing happens in it yet.
     *
     * @param answers what the simulated operator is told to answer
     * @throws IllegalArgumentException naming the parameter or the interrupt, if a given one does not fit the plan
     */
    public InProcessRun(RunPlan plan, RunSettings settings, AnswersFile answers, RunJournal journal) {
        this.settings = settings;
        this.journal = journal;
        Map<String, Value> parameters =
                new Parameters(plan.vocabulary(), plan.project(), plan.plan()).read(settings.parameters());
        RunSettings.Fleet fleet = settings.fleet();
        SimulatedBoatConnector connector = new SimulatedBoatConnector(executor);
        session = open(plan, settings, journal, new SessionRuntime.OneThread(clock, executor, connector));
        RunNotes notes = new RunNotes(line -> {});
        session.addListener(notes);
        water = new SimulatedWater(clock, fleet, connector::listenerOf);
        connector.launch(water);
        OperatorDefaults defaults = new OperatorDefaults(
                water.quay(),
                fleet.site().centreInProcess(),
                fleet.areaM(),
                fleet.locations(),
                fleet.seed(),
                fleet.boatNames());
        operator = new SimulatedOperatorDriver(
                new SimulatedOperator(plan.vocabulary(), defaults, answers),
                clock,
                settings.answerAfterMillis(),
                water.quay());
        InterruptScheduler interrupts = new InterruptScheduler(
                new PlanInterrupts(plan.vocabulary(), plan.project(), plan.plan())
                        .read(settings.interrupts(), fleet.boatNames()),
                clock);
        records = new RunRecords(plan, settings, session, water.plane(), notes, operator, interrupts);
        if (!fleet.conditions().hasExactPositions()) {
            records.alsoNote(water::reportedBoats);
        }
        records.listeners().forEach(session::addListener);
        session.addOperator(operator);
        operator.connect(session);
        interrupts.connect(session.host());
        lifecycle = new RunLifecycle(plan, settings, parameters, session, records);
    }

    private static Session open(RunPlan plan, RunSettings settings, RunJournal journal, SessionRuntime world) {
        try {
            return Session.open(new SessionSetup(
                    plan.vocabulary(),
                    plan.project(),
                    SessionJournal.over(journal.inputs()),
                    CrwServices.STANDARD.drivenWith(
                            settings.fleet().conditions().crossTrackError()),
                    world));
        } catch (IOException noFile) {
            throw new UncheckedIOException(noFile); // it reads none
        }
    }

    /**
     * Runs it to its end, to the set time, or until somebody wants it to stop.
     *
     * @param pacer keeps its time; not asked while the run only catches up with its journal
     */
    public RunReport run(Pacer pacer, RunObserver observer) {
        long wallStart = System.nanoTime();
        RunObserver.News news = observer.news();
        RunObserver.News whenNew = new RunObserver.News(line -> tellIfNew(line, news), news.isDetailed());
        RunOutcome outcome;
        double wallSeconds;
        RunNews told = new RunNews(session.models(), clock::nowMs, whenNew);
        water.fleet().startHelpers(helpers);
        try {
            begin(observer);
            outcome = loop(pacer, observer);
            wallSeconds = (System.nanoTime() - wallStart) / 1e9;
            executor.drain(); // what the models are still to show
        } finally {
            told.close();
            water.fleet().endHelpers();
        }
        return records.report(new ReportEnd(
                outcome,
                lifecycle.fault().orElse(""),
                now(),
                wallSeconds,
                journal.resumedFrom(),
                water.boats(),
                this::link));
    }

    /** What happened before the process died was told then. */
    private void tellIfNew(String line, RunObserver.News news) {
        if (!catchingUp) {
            news.lines().accept(line);
        }
    }

    private BoatProxy proxy(String boat) {
        return water.fleet().proxies().find(boat).orElseThrow();
    }

    private LinkResult link(String boat) {
        BoatProxy proxy = proxy(boat);
        return new LinkResult(
                LINK,
                proxy.status().bootId(),
                0,
                0,
                Uploads.of(proxy.commands().uploads()),
                proxy.explain().text());
    }

    /** The session on which it runs, for a window that shows it; on the run's thread. */
    public Session session() {
        return session;
    }

    /** Lets it run to its time also when nothing can happen in the mission any longer. To be called before it runs. */
    public void goOnWhenStuck() {
        endsWhenStuck = false;
    }

    /**
     * Has the boats of large fleets ticked on all cores of the machine: for who makes one run at a time. It changes only how long a run takes. To be called
     * before it runs.
     */
    public void useAllCores() {
        boolean isWorthIt = settings.speed().isMax() && settings.fleet().boats() >= BOATS_FOR_HELPERS;
        useHelpers(isWorthIt ? Math.min(MOST_HELPERS, Runtime.getRuntime().availableProcessors() - 1) : 0);
    }

    /** Has so many threads help to tick the boats. To be called before it runs. */
    void useHelpers(int count) {
        helpers = count;
    }

    /** Somebody else watches the engine. To be called before it runs. */
    public void addListener(HostListener listener) {
        session.addListener(listener);
    }

    /** Asks the engine's state, between or after runs. */
    public <T> T ask(Function<EngineView, T> question) {
        return session.host().ask(question);
    }

    /** What the simulated operator could not answer, in words, oldest first. */
    public List<String> operatorTroubles() {
        return operator.troubles();
    }

    /** The boats and their time, for tests. */
    SimulatedWater water() {
        return water;
    }

    /** The engine's host, for tests. */
    EngineHost host() {
        return session.host();
    }

    /** What lies before the operator of this run, for tests. */
    OperatorModels models() {
        return session.models();
    }

    /** Lets the world go on without the mission: what boats do when nobody wants anything of them any more. */
    void coast(long millis) {
        long until = now() + millis;
        for (long next = now(); next <= until; next = clock.nextTimeMs().orElse(Long.MAX_VALUE)) {
            executor.drain();
            clock.runNext();
        }
        executor.drain();
    }

    private void begin(RunObserver observer) {
        session.begin();
        boolean isWatched = observer.isWatched();
        repeat(LOOK_MILLIS, () -> {
            if (records.visits().count() > 0) {
                records.lookAtTruth(now(), water.boats());
            }
            if (isWatched) {
                observer.progress().accept(records.progress(catchingUp ? "catching up" : "running"));
            }
        });
        repeat(TRACK_MILLIS, () -> {
            records.tracks().look(now(), water.boats());
            records.lookAtReported(now());
        });
        repeat(MARK_MILLIS, this::mark);
        if (endsWhenStuck) {
            repeat(STALL_MILLIS, () -> lifecycle.lookForStall(water::boats));
        }
        water.fleet().start();
    }

    /** Every so often, from now on. The world's clock runs nothing else at any moment. */
    private void repeat(long everyMillis, Runnable action) {
        action.run();
        clock.after(everyMillis, () -> repeat(everyMillis, action));
    }

    private RunOutcome loop(Pacer pacer, RunObserver observer) {
        while (true) {
            executor.drain();
            startWhenAllAreThere();
            markAfterEntries();
            Optional<RunOutcome> over = outcome();
            if (over.isPresent()) {
                return over.get();
            }
            if (observer.stop().getAsBoolean()) {
                return stopped();
            }
            long next = clock.nextTimeMs().orElseThrow();
            if (next > settings.stopMillis()) {
                clock.runUntil(settings.stopMillis());
                return stopped();
            }
            pace(pacer, next);
            clock.runNext();
        }
    }

    private RunOutcome stopped() {
        try {
            journal.stopped(now());
        } catch (IOException e) {
            lifecycle.fail(e.getMessage());
        }
        return lifecycle.fault().isEmpty() ? RunOutcome.RUNNING : RunOutcome.FAILED;
    }

    private void pace(Pacer pacer, long nextMillis) {
        if (catchingUp) {
            catchingUp = journal.isCatchingUp();
            if (!catchingUp) {
                pacer.start(now());
            }
        }
        if (!catchingUp) {
            pacer.awaitTurn(nextMillis);
        }
    }

    private void startWhenAllAreThere() {
        if (lifecycle.hasStarted()) {
            return;
        }
        if (positionsAreKnown()) {
            lifecycle.startWhenAllHaveJoined();
            executor.drain();
        }
        if (!lifecycle.hasStarted() && now() > JOIN_MILLIS) {
            lifecycle.fail("only " + records.mission().boatsJoined() + " of "
                    + settings.fleet().boats() + " boats answered");
        }
    }

    /** A plan may ask for an allocation with its first event; that needs to know where the boats are. */
    private boolean positionsAreKnown() {
        return water.fleet().proxies().all().stream()
                .allMatch(boat -> boat.status().pose().isPresent());
    }

    private Optional<RunOutcome> outcome() {
        boolean failedBefore = lifecycle.fault().isPresent();
        Optional<RunOutcome> outcome = lifecycle.outcome();
        if (!failedBefore && records.mission().outcome().isPresent()) {
            try {
                journal.over();
            } catch (IOException e) {
                lifecycle.fail(e.getMessage());
                return Optional.of(RunOutcome.FAILED);
            }
        }
        return outcome;
    }

    private void markAfterEntries() {
        if (journal.inputs().lastIndex() >= markedIndex + MARK_ENTRIES) {
            mark();
        }
    }

    private void mark() {
        long index = journal.inputs().lastIndex();
        if (index == 0 || lifecycle.fault().isPresent()) {
            return;
        }
        markedIndex = index;
        try {
            journal.mark(now(), water::fingerprint);
        } catch (IOException e) {
            lifecycle.fail(e.getMessage());
        }
    }

    private long now() {
        return clock.nowMs();
    }
}
