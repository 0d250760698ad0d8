package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.OperatorDefaults;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.session.FleetHistory;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.clock.CatchUpScheduler;
import org.sami.crw.sim.report.LocationResult;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.run.RunLifecycle;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.ReportEnd;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.record.RunProgress;
import org.sami.crw.sim.run.record.RunRecords;
import org.sami.crw.sim.run.record.TrackRecorder;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.crw.sim.run.settings.PlannedInterrupt;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.host.HostListener;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * Starts the run's mission, listens to its session, and knows when it is over. For the engine's thread from {@link #begin} to its end,
 * but where said.
 */
final class RunMonitor implements SessionListener {
    private static final long LOOK_MS = 200;
    private static final long TRACK_MS = 1000;
    private static final long STALL_MS = 1000;
    private static final String RUNNING = "running";

    private final RunSettings settings;
    private final ConnectedJournal journal;
    private final Session session;
    private final RunBoats fleet;
    private final CatchUpScheduler clock = new CatchUpScheduler();
    private final SimulatedOperatorDriver operator;
    private final InterruptScheduler interrupts;
    private final RunRecords records;
    private final RunLifecycle lifecycle;
    private final CountDownLatch over = new CountDownLatch(1);
    private Map<String, FleetHistory.Told> toldBefore = Map.of(); // a track period ago, by boat
    private Optional<RunOutcome> ended = Optional.empty();
    private volatile boolean stopAsked;
    private volatile RunProgress progress;

    /**
     * A watch over a mission that has not begun, or not gone on.
     *
     * @param area in which the locations lie, and the boats
     * @throws UnknownBoatException if an interrupt names another boat
     */
    RunMonitor(
            RunPlan plan,
            RunSettings settings,
            Map<String, Value> parameters,
            AnswersFile answers,
            ConnectedJournal journal,
            Session session,
            RunNotes notes,
            RunArea area)
            throws UnknownBoatException {
        this.settings = settings;
        this.journal = journal;
        this.session = session;
        GeoPoint centre = area.centre();
        LocalFrame plane = new LocalFrame(centre.latDeg(), centre.lonDeg());
        fleet = new RunBoats(session.fleet().history(), plane);
        RunSettings.Fleet size = settings.fleet();
        OperatorDefaults defaults = new OperatorDefaults(centre, size.areaM(), size.locations(), size.seed());
        operator = new SimulatedOperatorDriver(
                new SimulatedOperator(plan.vocabulary(), defaults, answers),
                clock,
                settings.answerAfterMillis(),
                defaults.quay());
        interrupts = new InterruptScheduler(planned(plan, settings, area), clock);
        records = new RunRecords(plan, settings, session, plane, notes, operator, interrupts);
        lifecycle = new RunLifecycle(plan, settings, parameters, session, records);
        progress = records.progress(RUNNING);
        session.addOperator(operator);
        session.leavePosesToCaller(); // tracks are thinned first
    }

    private static List<PlannedInterrupt> planned(RunPlan plan, RunSettings settings, RunArea area)
            throws UnknownBoatException {
        try {
            return new PlanInterrupts(plan.vocabulary(), plan.project(), plan.plan())
                    .read(settings.interrupts(), area.boats());
        } catch (IllegalArgumentException e) {
            throw new UnknownBoatException(e.getMessage());
        }
    }

    /** Takes in what happened in earlier processes; before anything happens in this one. */
    void catchUp(EarlierRun earlier) throws IOException {
        session.replay((index, atMillis, input, effects, view) -> {
            clock.advanceTo(atMillis);
            for (HostListener listener : records.listeners()) {
                listener.onStep(index, atMillis, input, effects, view);
            }
        });
        clock.advanceTo(journal.cameToMillis());
        earlier.feed(records.folds(), fleet);
        lifecycle.caughtUp();
    }

    /** Whether the mission was over in an earlier process. */
    boolean wasOver() {
        return records.mission().outcome().isPresent();
    }

    /** Begins; from now on everything happens on the engine's thread. */
    void begin() {
        records.listeners().forEach(session::addListener);
        clock.goLive(session.scheduler());
        operator.connect(session);
        interrupts.connect(session.host());
        session.addListener((SessionListener) this);
        session.addListener((index, atMillis, input, effects, view) -> check());
        session.execute(() -> {
            repeat(LOOK_MS, this::look);
            repeat(TRACK_MS, this::track);
            repeat(STALL_MS, () -> lifecycle.lookForStall(this::boats));
        });
        session.scheduler().at(settings.stopMillis(), this::check);
        session.begin();
    }

    private void repeat(long everyMillis, Runnable action) {
        action.run();
        session.scheduler().after(everyMillis, () -> repeat(everyMillis, action));
    }

    /** Somebody wants the run to stop. From any thread. */
    void stop() {
        stopAsked = true;
        session.execute(this::check);
    }

    /** Waits for the end, for so many milliseconds at most. From any thread. */
    boolean awaitEnd(long millis) throws InterruptedException {
        return over.await(millis, TimeUnit.MILLISECONDS);
    }

    /** How it ended; when it has. */
    RunOutcome ended() {
        return ended.orElse(RunOutcome.FAILED);
    }

    /** Ends the run where it is over, before anything else happens. */
    private void check() {
        if (ended.isEmpty()) {
            ended = outcome();
            ended.ifPresent(how -> session.halt().thenRun(over::countDown));
        }
    }

    @Override
    public void onBroken(String reason) {
        lifecycle.fail("the run broke: " + reason);
        over.countDown();
    }

    /** How far it is. From any thread. */
    RunProgress latest() {
        return progress;
    }

    private List<BoatState> boats() {
        return fleet.all();
    }

    private void look() {
        long at = now(); // one time for the report and for the journal, which tells the report again
        for (LocationResult news : records.visits().look(at, boats())) {
            String boat = news.reported().orElseThrow().boat();
            session.telemetry().visited(at, boat, GeoPoint.of(news.latDeg(), news.lonDeg()));
        }
        progress = records.progress(RUNNING);
        check();
    }

    @Override
    public void onPassed(String boat, List<GeoPoint> points, long atMillis) {
        session.execute(() -> points.forEach(point -> records.folds().visit(boat, point, atMillis)));
    }

    private void track() {
        long at = now();
        Map<String, FleetHistory.Told> now = new HashMap<>();
        List<BoatState> boats = boats();
        boats.forEach(boat -> session.fleet().history().last(boat.id()).ifPresent(told -> now.put(boat.id(), told)));
        for (TrackRecorder.Noted noted : records.tracks().look(at, boats)) {
            BoatState boat = noted.boat();
            FleetHistory.Told told = (noted.atMillis() < at ? toldBefore : now).get(boat.id());
            if (told != null) {
                session.telemetry().pose(noted.atMillis(), boat.id(), told, boat.distanceM());
            }
        }
        toldBefore = now;
    }

    /** Whether and how it is over; asked again and again. */
    Optional<RunOutcome> outcome() {
        lifecycle.startWhenAllHaveJoined();
        Optional<RunOutcome> outcome = lifecycle.outcome();
        return outcome.isEmpty() && (stopAsked || now() >= settings.stopMillis())
                ? Optional.of(RunOutcome.RUNNING)
                : outcome;
    }

    private long now() {
        return session.scheduler().nowMs();
    }

    /** When the run was over, in ms since its start; now if nothing but its process ends. */
    long endMillis() {
        return records.mission().endedAtMillis().orElseGet(this::now);
    }

    /** Writes down where the boats have come to lie, and why they moved or did not, so that the run can be reported again. */
    void noteEnd(long atMillis) {
        for (BoatState boat : boats()) {
            session.telemetry().why(atMillis, boat.id(), fleet.link(boat.id()).why());
            session.fleet()
                    .history()
                    .last(boat.id())
                    .ifPresent(told -> session.telemetry().pose(atMillis, boat.id(), told, boat.distanceM()));
        }
        session.telemetry().flush();
    }

    /** The report; when everything has ended. */
    RunReport report(RunOutcome outcome, long atMillis, double wallSeconds) {
        List<BoatState> boats = boats();
        Optional<String> fault = lifecycle.fault();
        String why = outcome == RunOutcome.ENDED || fault.isEmpty()
                ? fault.orElse("")
                : fault.get()
                        + boats.stream()
                                .map(boat -> "; " + fleet.link(boat.id()).why())
                                .collect(Collectors.joining());
        session.models().shown().toCompletableFuture().join();
        return records.report(
                new ReportEnd(outcome, why, atMillis, wallSeconds, journal.resumedFrom(), boats, fleet::link));
    }
}
