package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.session.SensorValue;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.host.HostListener;
import org.sami.spn.value.GeoPoint;

/**
 * What a run writes down while it goes, and its report: feeds the report's folds from its session, and adds those parts that no journal
 * holds, such as where simulated boats truly were. What is so now, such as open decisions, is read from the operator's models. For the
 * engine's thread.
 */
public final class RunRecords {
    private final RunPlan plan;
    private final RunSettings settings;
    private final Session session;
    private final LocalFrame plane;
    private final SimulatedOperatorDriver operator;
    private final InterruptScheduler interrupts;
    private final ReportFolds folds;
    private final TrueVisits trueVisits;
    private final TrackRecorder reported = new TrackRecorder();
    private Optional<Supplier<List<BoatState>>> reporting = Optional.empty();

    /**
     * Records of a run in which nothing has happened yet.
     *
     * @param plane around the area's centre
     */
    public RunRecords(
            RunPlan plan,
            RunSettings settings,
            Session session,
            LocalFrame plane,
            RunNotes notes,
            SimulatedOperatorDriver operator,
            InterruptScheduler interrupts) {
        this.plan = plan;
        this.settings = settings;
        this.session = session;
        this.plane = plane;
        this.operator = operator;
        this.interrupts = interrupts;
        folds = new ReportFolds(plan.project(), plan.vocabulary(), plane, notes.fold());
        trueVisits = new TrueVisits(folds.visits());
        addWhatOnlyTheRunKnows();
        session.addListener(new SessionListener() {
            @Override
            public void onReading(SensorValue reading) {
                folds.reading(reading);
            }
        });
        if (!settings.isConnected()) { // else the run's monitor hears it, on the engine's thread
            folds.add(trueVisits);
            folds.add(this::addTrueTracks);
            session.addListener(new SessionListener() {
                @Override
                public void onPassed(String boat, List<GeoPoint> points, long atMillis) {
                    points.forEach(point -> folds.visit(boat, point, atMillis));
                }
            });
        }
    }

    private void addWhatOnlyTheRunKnows() {
        AnnouncedDepth announced = new AnnouncedDepth();
        session.subscribe(Runnable::run, announced);
        folds.add(announced);
        folds.add(draft -> draft.interrupts(interrupts.results()));
        folds.add(draft -> draft.note(operator.notes()));
        folds.add(draft -> session.telemetry()
                .problem()
                .map(note -> new NoteResult(note.atMillis(), note.kind(), note.mission(), note.text()))
                .ifPresent(problem -> draft.note(List.of(problem))));
        folds.add(new FenceNotes(session.models()));
        folds.add(new StuckNotes(session.models(), session.scheduler()::nowMs));
        folds.add(
                draft -> draft.actions(OperatorActions.of(session.models().log().snapshot())));
        folds.add(draft -> draft.waits(
                draft.end().outcome().isOver()
                        ? List.of()
                        : session.host().ask(view -> BlockedPlaces.of(plan.vocabulary(), view))));
    }

    /** What is known of the tracks is how they truly are; what boats reported is something else where positions are not exact. */
    private void addTrueTracks(ReportDraft draft) {
        List<BoatResult> truly = draft.tracks().best();
        List<BoatResult> said = reporting
                .map(boats -> reported.results(
                        draft.end().atMillis(), boats.get(), draft.end().links()))
                .orElse(truly);
        draft.tracks(new KnownTracks(said, Optional.of(truly)));
    }

    /** Who must hear of every step of the engine, in this order. */
    public List<HostListener> listeners() {
        List<HostListener> listeners = new ArrayList<>(folds.listeners());
        listeners.add(interrupts);
        return listeners;
    }

    /** The report's folds. */
    public ReportFolds folds() {
        return folds;
    }

    /** The run's mission. */
    public RunMission mission() {
        return folds.mission();
    }

    /** Which locations boats came to, by what they report. */
    public VisitRecorder visits() {
        return folds.visits();
    }

    /** Looks where boats of this process truly are, however they err. */
    public void lookAtTruth(long nowMillis, List<BoatState> boats) {
        trueVisits.look(nowMillis, boats);
    }

    /** Where boats were. */
    public TrackRecorder tracks() {
        return folds.tracks();
    }

    /** What is told of the boats is how they truly are: where they say that they are is something else, and noted down where they explore. */
    public void alsoNote(Supplier<List<BoatState>> asReported) {
        reporting = Optional.of(asReported);
    }

    /** Looks where boats say that they are; to be called once a second. */
    public void lookAtReported(long nowMillis) {
        if (reporting.isPresent() && folds.hasExplorations()) {
            reported.look(nowMillis, reporting.get().get());
        }
    }

    /** Who answers the run's decisions. */
    public SimulatedOperatorDriver operator() {
        return operator;
    }

    /** Who presses the run's interrupts. */
    public InterruptScheduler interrupts() {
        return interrupts;
    }

    /** How far the run is, by the operator's models. */
    public RunProgress progress(String phase) {
        OperatorModels models = session.models();
        double least = models.fleet().snapshot().stream()
                .map(BoatSnapshot::battery)
                .flatMap(battery -> battery.stream())
                .mapToDouble(BatteryState::percent)
                .min()
                .orElse(100);
        return new RunProgress(
                phase,
                session.scheduler().nowMs(),
                visits().visited(),
                visits().count(),
                models.decisions().pending().size(),
                models.missions().snapshot().firings(),
                least);
    }

    /** The report. The models show all that happened before. */
    public RunReport report(ReportEnd end) {
        return folds.report(RunHeaders.of(plan, settings, plane), end);
    }
}
