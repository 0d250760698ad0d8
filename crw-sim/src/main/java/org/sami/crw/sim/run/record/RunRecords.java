package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Function;
import java.util.function.Supplier;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.LinkResult;
import org.sami.crw.sim.report.LocationResult;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RunLog;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.host.HostListener;
import org.sami.spn.value.GeoPoint;

/**
 * What a run writes down while it goes, and its report. What is so now, such as open decisions and clicks, is read from the operator's
 * models; written down is what they do not keep: the whole history. For the engine's thread.
 */
public final class RunRecords {
    private final RunPlan plan;
    private final RunSettings settings;
    private final Session session;
    private final LocalFrame plane;
    private final RunNotes notes;
    private final SimulatedOperatorDriver operator;
    private final InterruptScheduler interrupts;
    private final RunRecorder recorder;
    private final VisitRecorder visits = new VisitRecorder();
    private final TrueVisits trueVisits = new TrueVisits(visits);
    private final TrackRecorder tracks = new TrackRecorder();
    private final TrackRecorder reported = new TrackRecorder();
    private Optional<Supplier<List<BoatState>>> reporting = Optional.empty();
    private final ReadingRecorder readings = new ReadingRecorder();
    private final LocationListener locations;
    private final PlanMap map;
    private final FenceNotes fences;
    private final StuckNotes stuck;
    private final AnnouncedDepth announced = new AnnouncedDepth();
    private final PhaseRecorder phases;

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
        this.notes = notes;
        this.operator = operator;
        this.interrupts = interrupts;
        recorder = new RunRecorder(plan.project());
        locations = new LocationListener(visits, plane);
        map = new PlanMap(plane);
        phases = new PhaseRecorder(plan.vocabulary());
        fences = new FenceNotes(session.models());
        stuck = new StuckNotes(session.models(), session.scheduler()::nowMs);
        session.addListener((SessionListener) readings);
        session.subscribe(Runnable::run, announced);
        if (!settings.isConnected()) { // else the run's monitor hears it, on the engine's thread
            session.addListener(new SessionListener() {
                @Override
                public void onPassed(String boat, List<GeoPoint> points, long atMillis) {
                    points.forEach(point -> visits.visited(point.latDeg(), point.lonDeg(), atMillis, boat));
                }
            });
        }
    }

    /** Who must hear of every step of the engine, in this order. */
    public List<HostListener> listeners() {
        return List.of(recorder, locations, interrupts, map, phases);
    }

    /** What the engine did. */
    public RunRecorder recorder() {
        return recorder;
    }

    /** Which locations boats came to, by what they report. */
    public VisitRecorder visits() {
        return visits;
    }

    /** Looks where boats of this process truly are, however they err. */
    public void lookAtTruth(long nowMillis, List<BoatState> boats) {
        trueVisits.look(nowMillis, boats);
    }

    private List<LocationResult> locations() {
        return settings.isConnected() ? visits.locations() : trueVisits.locations();
    }

    /** Where boats were. */
    public TrackRecorder tracks() {
        return tracks;
    }

    /** What is told of the boats is how they truly are: where they say that they are is something else, and noted down where they explore. */
    public void alsoNote(Supplier<List<BoatState>> asReported) {
        reporting = Optional.of(asReported);
    }

    /** Looks where boats say that they are; to be called once a second. */
    public void lookAtReported(long nowMillis) {
        if (reporting.isPresent() && map.hasExplorations()) {
            reported.look(nowMillis, reporting.get().get());
        }
    }

    /** What boats measured. */
    public ReadingRecorder readings() {
        return readings;
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
                visits.visited(),
                visits.count(),
                models.decisions().pending().size(),
                models.missions().snapshot().firings(),
                least);
    }

    /**
     * The report. The models show all that happened before.
     *
     * @param boats as they are at the end
     * @param resumedFrom index of the last input that was taken from a journal
     */
    public RunReport report(
            ReportBuilder.End end,
            List<BoatState> boats,
            Function<String, LinkResult> links,
            OptionalLong resumedFrom) {
        List<LocationResult> visited = locations();
        List<BoatResult> results = tracks.results(end.atMillis(), boats, links);
        return new ReportBuilder(plan, settings, recorder, resumedFrom, plane)
                .build(
                        end,
                        session.models().clicks().clicks(),
                        boats,
                        results,
                        visited,
                        interrupts.results(),
                        told(end.atMillis()),
                        map.map(known(results, end.atMillis(), links), visited).announcing(announced.mostM()))
                .withReadings(readings.readings())
                .withLog(new RunLog(
                        phases.results(),
                        OperatorActions.of(session.models().log().snapshot())))
                .withWaits(
                        end.outcome().isOver()
                                ? List.of()
                                : session.host().ask(view -> BlockedPlaces.of(plan.vocabulary(), view)));
    }

    private KnownTracks known(List<BoatResult> results, long atMillis, Function<String, LinkResult> links) {
        if (settings.isConnected()) {
            return KnownTracks.reported(results);
        }
        return new KnownTracks(
                reporting
                        .map(boats -> reported.results(atMillis, boats.get(), links))
                        .orElse(results),
                Optional.of(results));
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
        told.addAll(fences.all());
        told.addAll(stuck.all());
        return told;
    }
}
