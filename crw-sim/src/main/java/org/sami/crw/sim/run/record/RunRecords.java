package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.OperatorActionsPart;
import org.sami.crw.report.RunReport;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.session.record.SensorValue;
import org.sami.spn.host.HostListener;

/**
 * The records of a run and its report: feeds the report's folds from the session, and adds parts that no journal has, such as alarms at the fence.
 * The present state, such as open decisions, is read from the operator's models. For the engine's thread.
 */
public final class RunRecords {
    private final RunInput input;
    private final Session session;
    private final LocalFrame plane;
    private final SimulatedOperatorDriver operator;
    private final InterruptScheduler interrupts;
    private final ReportFolds folds;

    /**
     * Records of a run in which nothing has happened yet.
     *
     * @param plane around the area's centre
     */
    public RunRecords(
            RunInput input,
            Session session,
            LocalFrame plane,
            RunNotes notes,
            SimulatedOperatorDriver operator,
            InterruptScheduler interrupts) {
        this.input = input;
        this.session = session;
        this.plane = plane;
        this.operator = operator;
        this.interrupts = interrupts;
        folds = new ReportFolds(
                input.plan().project(),
                input.plan().vocabulary(),
                input.missions().size(),
                plane,
                notes.fold());
        addWhatOnlyTheRunKnows();
        session.addListener(new SessionListener() {
            @Override
            public void onReading(SensorValue reading) {
                folds.reading(reading);
            }
        });
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
        folds.add(draft -> draft.add(new OperatorActionsPart(
                OperatorActions.of(session.models().log().snapshot()))));
        folds.add(draft ->
                PictureResults.part(session.models().pictures().snapshot()).ifPresent(draft::add));
        folds.add(draft -> draft.waits(
                draft.end().outcome().isOver()
                        ? List.of()
                        : session.host()
                                .ask(view -> BlockedPlaces.of(input.plan().vocabulary(), view))));
    }

    /** The listeners to the engine's steps, in this order. */
    public List<HostListener> listeners() {
        List<HostListener> listeners = new ArrayList<>(folds.listeners());
        listeners.add(interrupts);
        return listeners;
    }

    /** The report's folds. */
    public ReportFolds folds() {
        return folds;
    }

    /** The progress of the run's missions. */
    public RunMission mission() {
        return folds.mission();
    }

    /** The locations that boats have reported as visited. */
    public VisitRecorder visits() {
        return folds.visits();
    }

    /** The boats' tracks. */
    public TrackRecorder tracks() {
        return folds.tracks();
    }

    /** Answers the run's decisions. */
    public SimulatedOperatorDriver operator() {
        return operator;
    }

    /** Presses the run's interrupts. */
    public InterruptScheduler interrupts() {
        return interrupts;
    }

    /** The progress of the run, from the operator's models. */
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
        return folds.report(RunHeaders.of(input.plan(), input.settings(), plane), end);
    }
}
