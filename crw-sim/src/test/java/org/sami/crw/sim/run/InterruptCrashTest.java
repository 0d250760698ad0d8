package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.resume.ResumedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.ProjectWriter;

/** A run with interrupts that dies after any entry of its journal is, taken up again, the run that never died. */
@Tag("long")
class InterruptCrashTest {
    private static final RunPlan PLAN = TestRuns.plan("clv-interrupts");
    private static final RunSettings SETTINGS = RunSettings.of(
                    "clv-interrupts", "visits", new FleetSettings(2, 5, 120, 4).with(InitialCharges.parse("100,15.5")))
            .limitMillis(3_600_000)
            .answerAfterMillis(4_000)
            .interrupts(List.of("recharge:1@25", "recharge@battery", "alarm@70", "recharge:1@71", "alarm@5000"))
            .build();

    @TempDir
    Path folder;

    @Test
    void crashAfterAnyEntryAndResumeIsTheSameRun() throws Exception {
        RunReport whole = run(RunJournal.none());
        assertThat(whole.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(whole.interrupts()).hasSize(5);
        assertThat(whole.interrupts()).filteredOn(InterruptResult::taken).hasSize(4);
        Map<Long, Path> crashes = new LinkedHashMap<>();
        Path file = folder.resolve("crash");
        try (WrittenJournal journal = WrittenJournal.create(file, record())) {
            run(CrashingJournal.leaving(journal, file, crashes));
        }

        for (Map.Entry<Long, Path> crash : crashes.entrySet()) {
            long entry = crash.getKey();
            try (ResumedJournal journal = ResumedJournal.open(crash.getValue())) {
                RunReport resumed = run(journal);

                assertThat(resumed.result().reason())
                        .as("crash after entry %d", entry)
                        .isEmpty();
                assertThat(resumed.result().runHash())
                        .as("crash after entry %d", entry)
                        .isEqualTo(whole.result().runHash());
                assertThat(resumed.interrupts())
                        .as("crash after entry %d", entry)
                        .isEqualTo(whole.interrupts());
            }
        }

        assertThat(crashes).hasSizeGreaterThan(40);
    }

    private static RunRecord record() {
        return new RunRecord(
                SETTINGS,
                "clv-interrupts.json",
                new ProjectWriter(PLAN.vocabulary()).text(PLAN.project()),
                TestRuns.LIBRARY.files().texts());
    }

    private static RunReport run(RunJournal journal) {
        return new InProcessRun(PLAN, SETTINGS, AnswersFile.EMPTY, journal).run(Pacer.UNPACED, RunObserver.NONE);
    }
}
