package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.report.OperatorActionsPart;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.clock.CatchUpScheduler;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.run.operator.InterruptScheduler;
import org.sami.crw.sim.run.record.NoteFold;
import org.sami.crw.sim.run.record.OperatorActions;
import org.sami.crw.sim.run.record.PictureResults;
import org.sami.crw.sim.run.record.ReportEnd;
import org.sami.crw.sim.run.record.ReportFolds;
import org.sami.crw.sim.run.record.RunHeaders;
import org.sami.crw.sim.run.settings.PlannedInterrupt;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.OperatorLogRows;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Reports what is in the journal of a session, or of a run over TCP, without going on with it: feeds it to the report's folds, all missions
 * together. Nothing is written to the journal, and a session may be writing it meanwhile.
 */
public final class JournalReport {
    private static final String TCP = "tcp";

    private final JournalAddress journal;
    private final List<TelemetryRow> rows;
    private final Project project;
    private final Vocabulary vocabulary;
    private final Optional<RunSettings> run; // empty for a session
    private final NoteFold notes = new NoteFold();
    private final FleetHistory history = new FleetHistory();
    private final EarlierRun telemetry;
    private final LocalFrame plane;
    private final ReportFolds folds;
    private List<Wait> waits = List.of();
    private long lastMillis;

    private JournalReport(JournalAddress journal, JournalReader reader) throws IOException {
        JournalHeader header = reader.header();
        this.journal = journal;
        rows = reader.telemetry().rows();
        vocabulary = JournalPlans.vocabulary(journal, header);
        project = JournalPlans.project(journal, header, vocabulary);
        run = TCP.equals(header.settings().get("kind"))
                ? Optional.of(RunRecord.of(header).settings())
                : Optional.empty();
        telemetry = new EarlierRun(rows, history, notes);
        RunArea area = telemetry.area().orElseGet(() -> RunArea.around(telemetry.firstPositions(), List.of()));
        GeoPoint centre = area.centre();
        plane = new LocalFrame(centre.latDeg(), centre.lonDeg());
        folds = new ReportFolds(
                project,
                vocabulary,
                1 + run.map(settings -> settings.also().size()).orElse(0),
                plane,
                notes);
        lastMillis = rows.stream().mapToLong(TelemetryRow::atMillis).max().orElse(0);
    }

    /**
     * The report of a journal.
     *
     * @throws IOException if it cannot be read
     */
    public static RunReport of(JournalAddress journal) throws IOException {
        try (JournalReader reader = journal.read()) {
            return new JournalReport(journal, reader).report(reader);
        }
    }

    private RunReport report(JournalReader reader) throws IOException {
        CatchUpScheduler clock = new CatchUpScheduler();
        InterruptScheduler interrupts = new InterruptScheduler(planned(), clock);
        folds.add(draft -> draft.interrupts(interrupts.results()));
        folds.add(draft -> draft.add(new OperatorActionsPart(OperatorActions.of(OperatorLogRows.read(rows)))));
        folds.add(draft -> PictureResults.part(journal, rows).ifPresent(draft::add));
        folds.add(draft -> draft.waits(waits));
        List<HostListener> listeners = new ArrayList<>(folds.listeners());
        listeners.add(interrupts);
        reader.replay(new Engine(vocabulary, project), 1, reader.lastIndex(), (index, at, input, effects, view) -> {
            clock.advanceTo(at);
            listeners.forEach(listener -> listener.onStep(index, at, input, effects, view));
            lastMillis = Math.max(lastMillis, at);
            if (index == reader.lastIndex()) {
                waits = waits(view);
            }
        });
        RunBoats boats = new RunBoats(history, plane);
        telemetry.feed(folds, boats);
        return folds.report(
                header(),
                new ReportEnd(
                        outcome(), "", endMillis(), 0, OptionalLong.of(reader.lastIndex()), boats.all(), boats::link));
    }

    private List<PlannedInterrupt> planned() {
        return runPlan()
                .map(plan -> {
                    List<String> boats = telemetry.area().map(RunArea::boats).orElse(List.of());
                    try {
                        return RunInput.of(plan, run.orElseThrow(), AnswersFile.EMPTY)
                                .interrupts()
                                .read(run.orElseThrow().interrupts(), boats);
                    } catch (IllegalArgumentException unknownBoat) {
                        return List
                                .<PlannedInterrupt>of(); // the telemetry does not say any longer which boats there were
                    }
                })
                .orElse(List.of());
    }

    private Optional<RunPlan> runPlan() {
        return run.flatMap(settings -> project.plan(settings.plan()))
                .map(plan -> new RunPlan(vocabulary, project, plan));
    }

    private RunHeader header() {
        return runPlan()
                .map(plan -> RunHeaders.of(plan, run.orElseThrow(), plane))
                .orElseGet(() -> RunHeaders.ofSession(project, vocabulary, plane));
    }

    /** A session goes on until somebody ends it; a run until its mission is over. */
    private RunOutcome outcome() {
        return run.flatMap(settings -> folds.mission().result()).orElse(RunOutcome.RUNNING);
    }

    private long endMillis() {
        return run.isPresent() ? folds.mission().endedAtMillis().orElse(lastMillis) : lastMillis;
    }

    private List<Wait> waits(EngineView view) {
        return outcome().isOver() ? List.of() : BlockedPlaces.of(vocabulary, view);
    }
}
