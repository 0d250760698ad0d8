package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RunHeader;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.report.RunResult;

/** Puts the report of a run together. */
final class ReportBuilder {
    private static final String LINK = "in-process";

    private final RunPlan plan;
    private final RunSettings settings;
    private final RunRecorder recorder;
    private final RunJournal journal;

    ReportBuilder(RunPlan plan, RunSettings settings, RunRecorder recorder, RunJournal journal) {
        this.plan = plan;
        this.settings = settings;
        this.recorder = recorder;
        this.journal = journal;
    }

    RunReport build(
            RunOutcome outcome,
            String reason,
            double wallSeconds,
            SimulatedWater water,
            VisitRecorder visits,
            TrackRecorder tracks,
            List<NoteResult> messages) {
        long now = water.clock().nowMs();
        List<BoatState> boats = water.boats();
        return new RunReport(
                new RunHeader(
                        plan.plan().id(),
                        plan.plan().title(),
                        settings.mission(),
                        settings.fleet().seed(),
                        settings.speed().toString(),
                        settings.fleet().areaM()),
                new RunResult(
                        outcome,
                        reason,
                        now,
                        wallSeconds,
                        recorder.clicks(),
                        recorder.firings().size(),
                        journal.resumedFrom(),
                        recorder.hash().with(boats)),
                tracks.results(now, boats, LINK),
                visits.locations(),
                recorder.decisions(),
                recorder.firings(),
                recorder.interrupts(),
                notes(messages));
    }

    private List<NoteResult> notes(List<NoteResult> messages) {
        List<NoteResult> notes = new ArrayList<>(recorder.notes());
        notes.addAll(messages);
        notes.sort(Comparator.comparingLong(NoteResult::atMillis)); // stable: of one moment in order of arrival
        return notes;
    }
}
