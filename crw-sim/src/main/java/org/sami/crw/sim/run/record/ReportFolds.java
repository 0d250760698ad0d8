package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunReport;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionNote;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The report of a run as a function of its journal and telemetry: a list of folds, each of which makes one part. Runs in process and over TCP,
 * resumed runs and exports of journals feed the same list. A new figure of the report is one more fold here. For the engine's thread, unless a fold
 * says otherwise.
 */
public final class ReportFolds {
    private final RunMission mission;
    private final VisitFold visits;
    private final TrackRecorder tracks = new TrackRecorder();
    private final PlanMap map;
    private final DepthFold depths;
    private final List<ReportFold> folds = new ArrayList<>();

    /**
     * Folds without data.
     *
     * @param missions how many root missions the run starts; 1 where nobody knows
     * @param plane around the area's centre
     * @param notes the messages to the operator, perhaps from before the area is known
     */
    public ReportFolds(Project project, Vocabulary vocabulary, int missions, LocalFrame plane, NoteFold notes) {
        mission = new RunMission(missions);
        visits = new VisitFold(plane);
        map = new PlanMap(plane);
        depths = new DepthFold(plane);
        folds.addAll(List.of(
                new FiringFold(project),
                new DecisionFold(),
                new EngineNoteFold(),
                new TaskRecorder(project),
                new HashFold(),
                new ClickFold(),
                new PhaseRecorder(vocabulary),
                notes,
                new ReadingRecorder(),
                depths,
                visits,
                tracks,
                map)); // the last: it looks at tracks and locations
    }

    /** Adds a fold that only some runs have, such as true positions; before anything is fed. */
    public void add(ReportFold more) {
        folds.add(folds.size() - 1, more);
    }

    /** The listeners to the engine's steps, in this order. */
    public List<HostListener> listeners() {
        List<HostListener> listeners = new ArrayList<>(folds);
        listeners.add(0, mission);
        return listeners;
    }

    /** The progress of the run's missions. */
    public RunMission mission() {
        return mission;
    }

    /** The locations that boats have reported as visited. */
    public VisitRecorder visits() {
        return visits.visits();
    }

    /** The map of the depths that boats measured. */
    public DepthFold depths() {
        return depths;
    }

    /** The boats' tracks. */
    public TrackRecorder tracks() {
        return tracks;
    }

    /** Whether boats were to explore areas. */
    public boolean hasExplorations() {
        return map.hasExplorations();
    }

    /** Feeds a message to the operator. */
    public void note(SessionNote note) {
        folds.forEach(fold -> fold.onNote(note));
    }

    /** Feeds a measurement; from any thread. */
    public void reading(SensorValue reading) {
        folds.forEach(fold -> fold.onReading(reading));
    }

    /** Feeds a boat's report that it visited a point. */
    public void visit(String boat, GeoPoint point, long atMillis) {
        folds.forEach(fold -> fold.onVisit(boat, point, atMillis));
    }

    /** Feeds a boat's position. */
    public void pose(long atMillis, BoatState boat) {
        folds.forEach(fold -> fold.onPose(atMillis, boat));
    }

    /** The report of everything that was fed. */
    public RunReport report(RunHeader header, ReportEnd end) {
        ReportDraft draft = new ReportDraft(end);
        folds.forEach(fold -> fold.addTo(draft));
        return draft.report(header);
    }
}
