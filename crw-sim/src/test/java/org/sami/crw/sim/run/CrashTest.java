package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.fleet.ExecutedCommand;
import org.sami.crw.sim.fleet.SimulatedBoat;
import org.sami.crw.sim.resume.ResumedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.ProjectWriter;

/** A run that dies after any entry of its journal and is taken up again is the run that never died. */
@Tag("long")
class CrashTest {
    @TempDir
    Path folder;

    @Test
    void crashAfterAnyEntryAndResumeIsTheSameRun() throws Exception {
        List<String> commands = new ArrayList<>();
        RunReport whole = uninterrupted(commands);
        assertThat(whole.result().outcome()).isEqualTo(RunOutcome.ENDED);
        Map<Long, Path> crashes = new LinkedHashMap<>();
        Path file = folder.resolve("crash");
        try (WrittenJournal journal = WrittenJournal.create(file, record())) {
            sample(CrashingJournal.leaving(journal, file, crashes)).run(Pacer.UNPACED, RunObserver.NONE);
        }

        for (Map.Entry<Long, Path> crash : crashes.entrySet()) {
            long entry = crash.getKey();
            try (ResumedJournal journal = ResumedJournal.open(crash.getValue())) {
                assertThat(journal.resumedFrom()).hasValue(entry);
                InProcessRun run = sample(journal);

                RunReport resumed = run.run(Pacer.UNPACED, RunObserver.NONE);

                assertThat(resumed.result().reason())
                        .as("crash after entry %d", entry)
                        .isEmpty();
                assertThat(resumed.result().runHash())
                        .as("crash after entry %d", entry)
                        .isEqualTo(whole.result().runHash());
                assertThat(commandsOf(run)).as("crash after entry %d", entry).isEqualTo(commands);
            }
        }

        assertThat(crashes).hasSizeGreaterThan(25);
        assertThat(new HashSet<>(commands)).hasSameSizeAs(commands);
    }

    @Test
    void resumedRunCanCrashAndBeResumedAgain() throws Exception {
        RunReport whole = uninterrupted(new ArrayList<>());
        Path file = folder.resolve("twice");
        assertThat(crashAfter(6, file)).isTrue();
        try (ResumedJournal journal = ResumedJournal.open(file)) {
            assertThatExceptionOfType(CrashingJournal.Crash.class)
                    .isThrownBy(() -> sample(new CrashingJournal(journal, 15)).run(Pacer.UNPACED, RunObserver.NONE));
        }

        try (ResumedJournal journal = ResumedJournal.open(file)) {
            RunReport resumed = sample(journal).run(Pacer.UNPACED, RunObserver.NONE);

            assertThat(resumed.result().runHash()).isEqualTo(whole.result().runHash());
            assertThat(resumed.result().resumedFrom()).isEqualTo(OptionalLong.of(15));
        }
    }

    @Test
    void journalOfAFinishedRunGivesTheSameReportAndIsLeftAlone() throws Exception {
        Path file = folder.resolve("finished");
        RunReport first;
        try (WrittenJournal journal = WrittenJournal.create(file, record())) {
            first = sample(journal).run(Pacer.UNPACED, RunObserver.NONE);
        }

        try (ResumedJournal journal = ResumedJournal.open(file)) {
            RunReport again = sample(journal).run(Pacer.UNPACED, RunObserver.NONE);

            assertThat(again.result().outcome()).isEqualTo(RunOutcome.ENDED);
            assertThat(again.result().runHash()).isEqualTo(first.result().runHash());
            assertThat(journal.added()).isZero();
        }
    }

    @Test
    void worldThatTakesAnotherCourseIsRefusedByEntry() throws Exception {
        Path file = folder.resolve("other");
        assertThat(crashAfter(25, file)).isTrue();

        try (ResumedJournal journal = ResumedJournal.open(file)) {
            RunSettings other = RunSettings.of("sample", "sample", new FleetSettings(3, 5, 120, 12))
                    .limitMillis(3_600_000)
                    .answerAfterMillis(4_000)
                    .build();
            RunReport refused = new InProcessRun(TestRuns.sample(), other, TestRuns.sampleAnswers(), journal)
                    .run(Pacer.UNPACED, RunObserver.NONE);

            assertThat(refused.result().outcome()).isEqualTo(RunOutcome.FAILED);
            assertThat(refused.result().reason()).containsPattern("entry \\d+ of the journal");
            assertThat(journal.added()).isZero();
        }
    }

    private RunReport uninterrupted(List<String> commands) {
        InProcessRun run = sample(RunJournal.none());
        RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);
        commands.addAll(commandsOf(run));
        return report;
    }

    /** Whether it came to that entry; false: the run ended before. */
    private static boolean crashAfter(long entry, Path file) throws IOException {
        try (WrittenJournal journal = WrittenJournal.create(file, record())) {
            sample(new CrashingJournal(journal, entry)).run(Pacer.UNPACED, RunObserver.NONE);
            return false;
        } catch (CrashingJournal.Crash crash) {
            return true;
        }
    }

    private static InProcessRun sample(RunJournal journal) {
        return new InProcessRun(TestRuns.sample(), TestRuns.sampleSettings(), TestRuns.sampleAnswers(), journal);
    }

    private static RunRecord record() {
        return new RunRecord(
                TestRuns.sampleSettings(),
                "sample-project.json",
                new ProjectWriter(TestRuns.LIBRARY.vocabulary())
                        .text(TestRuns.sample().project()),
                TestRuns.LIBRARY.files().texts());
    }

    private static List<String> commandsOf(InProcessRun run) {
        List<String> commands = new ArrayList<>();
        Set<String> ids = new HashSet<>();
        for (SimulatedBoat boat : run.water().fleet().boats()) {
            for (ExecutedCommand command : boat.executed()) {
                assertThat(ids.add(boat.id() + command.commandId())).isTrue();
                commands.add(boat.id() + " " + command.timeMs() + " " + command.commandId());
            }
        }
        return commands;
    }
}
