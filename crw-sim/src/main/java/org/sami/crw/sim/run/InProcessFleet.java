package org.sami.crw.sim.run;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.LinkResult.Uploads;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.ReportFolds;
import org.sami.crw.sim.run.record.RunProgress;
import org.sami.crw.sim.run.record.TrueTracks;
import org.sami.crw.sim.run.record.TrueVisits;
import org.sami.crw.sim.run.record.VesselApproaches;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.world.SimulatedWater;
import org.sami.session.record.FleetHistory;
import org.sami.spn.value.GeoPoint;

/**
 * Simulated boats in the run's only thread, on a virtual clock: drives the clock, keeps its pace and writes marks into the journal. A resumed run is
 * repeated from its start and compared with its journal.
 */
final class InProcessFleet implements RunFleet {
    private static final String LINK = "in-process";
    private static final long MARK_MILLIS = 10_000;
    private static final long MARK_ENTRIES = 10;
    private static final long JOIN_MILLIS = 30_000;

    private final RunSettings settings;
    private final RunJournal journal;
    private final LoopExecutor executor;
    private final VirtualClock clock;
    private final SimulatedWater water;
    private final Session session;
    private final TrueTracks trueTracks;
    private Optional<ReportFolds> report = Optional.empty();
    private Optional<TrueVisits> trueVisits = Optional.empty();
    private Optional<VesselApproaches> vesselApproaches = Optional.empty();
    private Pacer pacer = Pacer.UNPACED;
    private boolean catchingUp = true;
    private boolean endsWhenStuck = true;
    private long markedIndex;
    private int helpers;

    InProcessFleet(
            RunSettings settings,
            RunJournal journal,
            LoopExecutor executor,
            VirtualClock clock,
            SimulatedWater water,
            Session session) {
        this.settings = settings;
        this.journal = journal;
        this.executor = executor;
        this.clock = clock;
        this.water = water;
        this.session = session;
        trueTracks = new TrueTracks(
                settings.fleet().inProcess().conditions().hasExactPositions()
                        ? Optional.empty()
                        : Optional.of(water::reportedBoats));
    }

    /** Keeps the pace of the run; not called while the run repeats its journal. */
    void pacedBy(Pacer keeper) {
        pacer = keeper;
    }

    /** The run goes on until its time limit even if nothing can happen in the mission any longer. */
    void goOnWhenStuck() {
        endsWhenStuck = false;
    }

    /** Sets the number of threads that help to tick the boats. */
    void useHelpers(int count) {
        helpers = count;
    }

    @Override
    public LocalFrame plane() {
        return water.plane();
    }

    @Override
    public DefaultAnswers operatorDefaults() {
        FleetSettings fleet = settings.fleet();
        return new DefaultAnswers(
                water.quay(),
                fleet.site().centreInProcess(),
                fleet.areaM(),
                fleet.locations(),
                fleet.seed(),
                fleet.boatNames());
    }

    @Override
    public List<String> names() {
        return settings.fleet().boatNames();
    }

    @Override
    public List<BoatState> boats() {
        return water.boats();
    }

    @Override
    public LinkResult link(String boat) {
        BoatProxy proxy = water.fleet().proxies().find(boat).orElseThrow();
        FleetHistory.Link history = session.fleet().history().link(boat);
        Radio radio = settings.fleet().inProcess().radio();
        return new LinkResult(
                radio.isPerfect() ? LINK : LINK + ", radio " + radio,
                proxy.status().bootId(),
                history.lost(),
                history.reconnected(),
                Uploads.of(proxy.commands().uploads()),
                proxy.explain().text());
    }

    @Override
    public void addTo(ReportFolds folds) {
        TrueVisits visits = new TrueVisits(folds.visits());
        report = Optional.of(folds);
        trueVisits = Optional.of(visits);
        folds.add(visits);
        folds.add(trueTracks);
        settings.fleet().inProcess().layers().depths().ifPresent(folds.depths()::compareWith);
        if (!settings.fleet().inProcess().vessels().isEmpty()) {
            VesselApproaches approaches =
                    new VesselApproaches(settings.fleet().inProcess().vessels());
            vesselApproaches = Optional.of(approaches);
            folds.add(approaches);
        }
        session.addListener(new SessionListener() {
            @Override
            public void onPassed(String boat, List<GeoPoint> points, long atMillis) {
                points.forEach(point -> folds.visit(boat, point, atMillis));
            }
        });
    }

    @Override
    public void lookForVisits(long nowMillis) {
        vesselApproaches.ifPresent(approaches -> approaches.look(nowMillis, water.boats(), water.vessels()));
        if (report.orElseThrow().visits().count() > 0) {
            trueVisits.orElseThrow().look(nowMillis, water.boats());
        }
    }

    @Override
    public void track(long nowMillis) {
        report.orElseThrow().tracks().look(nowMillis, water.boats());
        if (report.orElseThrow().hasExplorations()) {
            trueTracks.look(nowMillis);
        }
    }

    @Override
    public RunObserver.News heard(RunObserver.News news) {
        return new RunObserver.News(line -> tellIfNew(line, news), news.isDetailed());
    }

    /** Events before the process died were reported then. */
    private void tellIfNew(String line, RunObserver.News news) {
        if (!catchingUp) {
            news.lines().accept(line);
        }
    }

    @Override
    public RunOutcome live(FleetRun run, RunObserver observer) {
        water.fleet().startHelpers(helpers);
        try {
            begin(run, observer);
            return loop(run, observer);
        } finally {
            water.fleet().endHelpers();
        }
    }

    private void begin(FleetRun run, RunObserver observer) {
        session.begin();
        boolean isWatched = observer.isWatched();
        run.followBoats(() -> {
            if (isWatched) {
                observer.progress().accept(run.progress(catchingUp ? "catching up" : RunProgress.RUNNING));
            }
        });
        run.repeat(MARK_MILLIS, () -> mark(run.lifecycle()));
        if (endsWhenStuck) {
            run.lookForStalls();
        }
        water.fleet().start();
    }

    private RunOutcome loop(FleetRun run, RunObserver observer) {
        RunLifecycle lifecycle = run.lifecycle();
        while (true) {
            executor.drain();
            startWhenAllAreThere(run);
            if (journal.inputs().lastIndex() >= markedIndex + MARK_ENTRIES) {
                mark(lifecycle);
            }
            Optional<RunOutcome> over = outcome(run);
            if (over.isPresent()) {
                return over.get();
            }
            if (observer.stop().getAsBoolean()) {
                return stopped(lifecycle);
            }
            long next = clock.nextTimeMs().orElseThrow();
            if (next > settings.stopMillis()) {
                clock.runUntil(settings.stopMillis());
                return stopped(lifecycle);
            }
            pace(next);
            clock.runNext();
        }
    }

    private RunOutcome stopped(RunLifecycle lifecycle) {
        try {
            journal.stopped(clock.nowMs());
        } catch (IOException e) {
            lifecycle.fail(String.valueOf(e.getMessage()));
        }
        return lifecycle.fault().isEmpty() ? RunOutcome.RUNNING : RunOutcome.FAILED;
    }

    private void pace(long nextMillis) {
        if (catchingUp) {
            catchingUp = journal.isCatchingUp();
            if (!catchingUp) {
                pacer.start(clock.nowMs());
            }
        }
        if (!catchingUp) {
            pacer.awaitTurn(nextMillis);
        }
    }

    private void startWhenAllAreThere(FleetRun run) {
        RunLifecycle lifecycle = run.lifecycle();
        if (lifecycle.hasStarted()) {
            return;
        }
        if (positionsAreKnown()) {
            lifecycle.startWhenAllHaveJoined();
            executor.drain();
        }
        if (!lifecycle.hasStarted() && clock.nowMs() > JOIN_MILLIS) {
            lifecycle.fail("only " + run.records().mission().boatsJoined() + " of "
                    + settings.fleet().boats() + " boats answered");
        }
    }

    /** A plan may ask for an allocation with its first event; that needs to know where the boats are. */
    private boolean positionsAreKnown() {
        return water.fleet().proxies().all().stream()
                .allMatch(boat -> boat.status().pose().isPresent());
    }

    private Optional<RunOutcome> outcome(FleetRun run) {
        RunLifecycle lifecycle = run.lifecycle();
        boolean failedBefore = lifecycle.fault().isPresent();
        Optional<RunOutcome> outcome = lifecycle.outcome();
        if (!failedBefore && run.records().mission().isOver()) {
            try {
                journal.over();
            } catch (IOException e) {
                lifecycle.fail(String.valueOf(e.getMessage()));
                return Optional.of(RunOutcome.FAILED);
            }
        }
        return outcome;
    }

    private void mark(RunLifecycle lifecycle) {
        long index = journal.inputs().lastIndex();
        if (index == 0 || lifecycle.fault().isPresent()) {
            return;
        }
        markedIndex = index;
        try {
            journal.mark(clock.nowMs(), water::fingerprint);
        } catch (IOException e) {
            lifecycle.fail(String.valueOf(e.getMessage()));
        }
    }

    @Override
    public void leave(long endMillis) {
        executor.drain(); // what the models are still to show
    }

    @Override
    public void awaitShown() {
        executor.drain();
    }
}
