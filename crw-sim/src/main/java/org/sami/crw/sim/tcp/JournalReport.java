package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.operator.ClickCount;
import org.sami.crw.session.FleetHistory;
import org.sami.crw.session.OperatorLogRows;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.MapPoint;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RunHeader;
import org.sami.crw.sim.report.RunLog;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunPlace;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.report.RunResult;
import org.sami.crw.sim.run.record.LocationListener;
import org.sami.crw.sim.run.record.OperatorActions;
import org.sami.crw.sim.run.record.PhaseRecorder;
import org.sami.crw.sim.run.record.PlanMap;
import org.sami.crw.sim.run.record.ReadingRecorder;
import org.sami.crw.sim.run.record.RunNotes;
import org.sami.crw.sim.run.record.RunRecorder;
import org.sami.crw.sim.run.record.TrackRecorder;
import org.sami.crw.sim.run.record.VisitRecorder;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.HostListener;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Reports what is in the journal of a session, or of a run over TCP, without going on with it: all missions together. Nothing is written
 * to the journal, and a session may be writing it meanwhile.
 */
public final class JournalReport {
    private static final int WHOLE_HASH = 64;

    private final JournalHeader header;
    private final List<TelemetryRow> rows;
    private final Project project;
    private final Vocabulary vocabulary;
    private final Engine engine;
    private final RunNotes notes = new RunNotes(line -> {});
    private final FleetHistory history = new FleetHistory();

    private JournalReport(Path file, JournalReader reader) throws IOException {
        header = reader.header();
        rows = reader.telemetry().rows();
        vocabulary = JournalPlans.vocabulary(file, header);
        project = JournalPlans.project(file, header, vocabulary);
        engine = new Engine(vocabulary, project);
    }

    /**
     * The report of a journal.
     *
     * @throws IOException if it cannot be read
     */
    public static RunReport of(Path file) throws IOException {
        try (JournalReader reader = JournalReader.open(file)) {
            return new JournalReport(file, reader).report(reader);
        }
    }

    private RunReport report(JournalReader reader) throws IOException {
        EarlierRun earlier = new EarlierRun(rows, history, notes);
        List<GeoPoint> first = earlier.firstPositions();
        GeoPoint centre = earlier.area()
                .map(RunArea::centre)
                .orElseGet(() -> RunArea.around(first, List.of()).centre());
        LocalFrame plane = new LocalFrame(centre.latDeg(), centre.lonDeg());
        VisitRecorder visits = new VisitRecorder();
        RunRecorder recorder = new RunRecorder(project);
        PlanMap map = new PlanMap(plane);
        PhaseRecorder phases = new PhaseRecorder(vocabulary);
        ClickCount clicks = new ClickCount();
        long[] last = {rows.stream().mapToLong(TelemetryRow::atMillis).max().orElse(0)};
        List<HostListener> listeners = List.of(recorder, new LocationListener(visits, plane), map, phases);
        reader.replay(engine, 1, reader.lastIndex(), (index, atMillis, input, effects, view) -> {
            listeners.forEach(listener -> listener.onStep(index, atMillis, input, effects, view));
            clicks.count(input, effects);
            last[0] = Math.max(last[0], atMillis);
        });
        RunBoats boats = new RunBoats(history, plane);
        TrackRecorder tracks = new TrackRecorder();
        earlier.takeUp(boats, tracks, visits);
        ReadingRecorder readings = new ReadingRecorder();
        earlier.readings().forEach(readings::onReading);
        List<BoatResult> results = tracks.results(last[0], boats.all(), boats::link);
        return new RunReport(
                        header(centre),
                        new RunResult(
                                RunOutcome.RUNNING,
                                "",
                                last[0],
                                0,
                                (int) clicks.clicks(),
                                recorder.firingCount(),
                                OptionalLong.of(reader.lastIndex()),
                                "0".repeat(WHOLE_HASH)),
                        results,
                        visits.locations(),
                        recorder.decisions(),
                        recorder.firings(),
                        List.of(),
                        notes(recorder),
                        map.map(results, visits.locations()))
                .withTasks(recorder.tasks())
                .withReadings(readings.readings())
                .withLog(new RunLog(phases.results(), OperatorActions.of(OperatorLogRows.read(rows))));
    }

    private RunHeader header(GeoPoint centre) {
        MapPoint origin = new MapPoint(centre.latDeg(), centre.lonDeg(), 0, 0);
        return new RunHeader(
                project.id(),
                project.name(),
                "0".repeat(WHOLE_HASH),
                header.settings().getOrDefault("kind", "session"),
                0,
                "1",
                0,
                new RunPlace(origin, Optional.empty()));
    }

    private List<NoteResult> notes(RunRecorder recorder) {
        List<NoteResult> all = new ArrayList<>(recorder.notes());
        all.addAll(notes.all());
        all.sort(Comparator.comparingLong(NoteResult::atMillis));
        return all;
    }
}
