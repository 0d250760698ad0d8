package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.sami.boat.server.LocalFrame;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.OperatorDefaults;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.operator.BlockedPlaces;
import org.sami.crw.session.FleetStatus;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.clock.CatchUpScheduler;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.LocationResult;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.run.BoatState;
import org.sami.crw.sim.run.InterruptScheduler;
import org.sami.crw.sim.run.LocationListener;
import org.sami.crw.sim.run.PlanInterrupts;
import org.sami.crw.sim.run.PlanMap;
import org.sami.crw.sim.run.PlannedInterrupt;
import org.sami.crw.sim.run.ReadingRecorder;
import org.sami.crw.sim.run.ReportBuilder;
import org.sami.crw.sim.run.RunNotes;
import org.sami.crw.sim.run.RunPlan;
import org.sami.crw.sim.run.RunProgress;
import org.sami.crw.sim.run.RunRecorder;
import org.sami.crw.sim.run.RunSettings;
import org.sami.crw.sim.run.SimulatedOperatorDriver;
import org.sami.crw.sim.run.StallDetector;
import org.sami.crw.sim.run.TrackRecorder;
import org.sami.crw.sim.run.VisitRecorder;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostStatus;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
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

    private final RunPlan plan;
    private final RunSettings settings;
    private final Map<String, Value> parameters;
    private final ConnectedJournal journal;
    private final Session session;
    private final RunNotes notes;
    private final LocalFrame plane;
    private final RunBoats fleet;
    private final CatchUpScheduler clock = new CatchUpScheduler();
    private final SimulatedOperatorDriver operator;
    private final InterruptScheduler interrupts;
    private final RunRecorder recorder;
    private final VisitRecorder visits = new VisitRecorder();
    private final TrackRecorder tracks = new TrackRecorder();
    private final StallDetector stall;
    private final LocationListener locations;
    private final PlanMap map;
    private final ReadingRecorder readings = new ReadingRecorder();
    private final CountDownLatch over = new CountDownLatch(1);
    private Map<String, FleetStatus.Told> toldBefore = Map.of(); // a track period ago, by boat
    private Optional<String> fault = Optional.empty();
    private Optional<RunOutcome> ended = Optional.empty();
    private boolean started;
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
        this.plan = plan;
        this.settings = settings;
        this.parameters = parameters;
        this.journal = journal;
        this.session = session;
        this.notes = notes;
        GeoPoint centre = area.centre();
        plane = new LocalFrame(centre.latDeg(), centre.lonDeg());
        fleet = new RunBoats(session.fleet().status(), plane);
        RunSettings.Fleet size = settings.fleet();
        OperatorDefaults defaults = new OperatorDefaults(centre, size.areaM(), size.locations(), size.seed());
        operator = new SimulatedOperatorDriver(
                new SimulatedOperator(plan.vocabulary(), defaults, answers), clock, settings.answerAfterMillis());
        interrupts = new InterruptScheduler(planned(plan, settings, area), clock);
        recorder = new RunRecorder(plan.project());
        locations = new LocationListener(visits, plane);
        map = new PlanMap(plane);
        stall = new StallDetector(session.host(), plan, operator, interrupts, recorder);
        progress = progress();
        session.addOperator(operator);
        session.addListener((SessionListener) readings);
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
            for (HostListener listener : listeners()) {
                listener.onStep(index, atMillis, input, effects, view);
            }
        });
        clock.advanceTo(journal.cameToMillis());
        earlier.takeUp(fleet, tracks, visits);
        earlier.readings().forEach(readings::onReading);
        started = recorder.root().isPresent();
    }

    private List<HostListener> listeners() {
        return List.of(recorder, locations, interrupts, map);
    }

    /** Whether the mission began in an earlier process. */
    boolean wasStarted() {
        return started;
    }

    /** Whether the mission was over in an earlier process. */
    boolean wasOver() {
        return recorder.outcome().isPresent();
    }

    /** Begins; from now on everything happens on the engine's thread. */
    void begin() {
        listeners().forEach(session::addListener);
        clock.goLive(session.scheduler());
        operator.connect(session);
        interrupts.connect(session.host());
        session.addListener((SessionListener) this);
        session.addListener((index, atMillis, input, effects, view) -> check());
        session.execute(() -> {
            repeat(LOOK_MS, this::look);
            repeat(TRACK_MS, this::track);
            repeat(STALL_MS, () -> session.lookAfterBoats(this::stall));
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
        fail("the run broke: " + reason);
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
        for (LocationResult news : visits.look(at, boats())) {
            session.telemetry().visited(at, news.visitedBy(), GeoPoint.of(news.latDeg(), news.lonDeg()));
        }
        progress = progress();
        check();
    }

    @Override
    public void onPassed(String boat, List<GeoPoint> points, long atMillis) {
        session.execute(() -> points.forEach(point -> arrived(boat, point, atMillis)));
    }

    /** It was written down where it was heard, with the same time. */
    private void arrived(String boat, GeoPoint point, long at) {
        visits.visited(point.latDeg(), point.lonDeg(), at, boat);
    }

    private void track() {
        long at = now();
        Map<String, FleetStatus.Told> now = new HashMap<>();
        List<BoatState> boats = boats();
        boats.forEach(boat -> session.fleet().status().last(boat.id()).ifPresent(told -> now.put(boat.id(), told)));
        for (TrackRecorder.Noted noted : tracks.look(at, boats)) {
            BoatState boat = noted.boat();
            FleetStatus.Told told = (noted.atMillis() < at ? toldBefore : now).get(boat.id());
            if (told != null) {
                session.telemetry().pose(noted.atMillis(), boat.id(), told, boat.distanceM());
            }
        }
        toldBefore = now;
    }

    /**
     * As long as a mission wants something of a boat that can move, something can happen: a link or an operator comes back. So it can
     * while a service still computes what boats are to do. Asked behind a look after the boats: on a busy machine what a mission
     * began to want may not have reached them yet.
     */
    private void stall() {
        if (!session.isComputing() && !session.fleet().status().someoneIsWanted()) {
            stall.look(now(), boats(), boat -> false).ifPresent(this::fail);
        }
    }

    /** Whether and how it is over; asked again and again. */
    Optional<RunOutcome> outcome() {
        startWhenAllHaveJoined();
        HostStatus status = session.host().status();
        if (status.kind() == HostStatus.Kind.FAILED) {
            fail(status.reason());
        }
        recorder.failure().ifPresent(this::fail);
        if (fault.isPresent()) {
            return Optional.of(RunOutcome.FAILED);
        }
        if (recorder.outcome().isPresent()) {
            return Optional.of(over(recorder.outcome().get()));
        }
        return stopAsked || now() >= settings.stopMillis() ? Optional.of(RunOutcome.RUNNING) : Optional.empty();
    }

    private void startWhenAllHaveJoined() {
        if (!started && recorder.boatsJoined() >= settings.fleet().boats()) {
            started = true;
            session.host().post(new Input.StartMission(plan.plan().id(), settings.mission(), parameters));
        }
    }

    private RunOutcome over(Outcome outcome) {
        return switch (outcome) {
            case ENDED, COMPLETED -> RunOutcome.ENDED;
            case ABORTED -> RunOutcome.ABORTED;
            case HALTED -> {
                fail("the mission was halted: it fired without end (livelock)");
                yield RunOutcome.FAILED;
            }
        };
    }

    /** Ends the run for a fault; the first one counts. */
    void fail(String reason) {
        if (fault.isEmpty()) {
            fault = Optional.of(reason);
        }
    }

    private long now() {
        return session.scheduler().nowMs();
    }

    private RunProgress progress() {
        double least =
                boats().stream().mapToDouble(BoatState::batteryPercent).min().orElse(100);
        return new RunProgress(
                "running",
                now(),
                visits.visited(),
                visits.count(),
                session.models().decisions().pending().size(),
                recorder.firingCount(),
                least);
    }

    /** When the run was over, in ms since its start; now if nothing but its process ends. */
    long endMillis() {
        return recorder.endedAtMillis().orElseGet(this::now);
    }

    /** Writes down where the boats have come to lie, and why they moved or did not, so that the run can be reported again. */
    void noteEnd(long atMillis) {
        for (BoatState boat : boats()) {
            session.telemetry().why(atMillis, boat.id(), fleet.link(boat.id()).why());
            session.fleet()
                    .status()
                    .last(boat.id())
                    .ifPresent(told -> session.telemetry().pose(atMillis, boat.id(), told, boat.distanceM()));
        }
        session.telemetry().flush();
    }

    /** The report; when everything has ended. */
    RunReport report(RunOutcome outcome, long atMillis, double wallSeconds) {
        List<BoatState> boats = boats();
        String why = outcome == RunOutcome.ENDED || fault.isEmpty()
                ? fault.orElse("")
                : fault.get()
                        + boats.stream()
                                .map(boat -> "; " + fleet.link(boat.id()).why())
                                .collect(Collectors.joining());
        List<BoatResult> results = tracks.results(atMillis, boats, fleet::link);
        return new ReportBuilder(plan, settings, recorder, journal.resumedFrom(), plane)
                .build(
                        new ReportBuilder.End(outcome, why, atMillis, wallSeconds),
                        boats,
                        results,
                        visits.locations(),
                        interrupts.results(),
                        told(atMillis))
                .withMap(map.map(results, visits.locations()))
                .withReadings(readings.readings())
                .withWaits(
                        outcome.isOver()
                                ? List.of()
                                : session.host().ask(view -> BlockedPlaces.of(plan.vocabulary(), view)));
    }

    private List<NoteResult> told(long atMillis) {
        List<NoteResult> told = new ArrayList<>(notes.all());
        told.addAll(readings.notes(atMillis));
        told.addAll(operator.notes());
        session.telemetry()
                .problem()
                .map(note -> new NoteResult(note.atMillis(), note.kind(), note.mission(), note.text()))
                .ifPresent(told::add);
        told.addAll(tracks.notes(atMillis));
        return told;
    }
}
