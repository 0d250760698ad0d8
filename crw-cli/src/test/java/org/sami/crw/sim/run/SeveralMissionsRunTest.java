package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.resume.ResumedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.ProjectWriter;

/** Runs that start more than one root mission. */
@Tag("long")
class SeveralMissionsRunTest {
    private static final RunPlan PLAN = TestRuns.plan("clv");
    private static final RunSettings SETTINGS =
            TestRuns.settings(PLAN, 3, 5, 7).withAlso(List.of("clv@3600", "clv@90.5"));

    @TempDir
    private Path folder;

    @Test
    void runIsOverWhenItsLastMissionIsAndEachStartsAtItsTime() {
        RunReport report = TestRuns.run(PLAN, SETTINGS);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.firings().stream().map(FiringResult::mission).distinct())
                .containsExactly(1L, 2L, 3L);
        assertThat(report.result().simulatedMillis()).isGreaterThan(3_600_000);
        assertThat(report.locations())
                .hasSize(15)
                .allMatch(location -> location.reported().isPresent());
        List<Long> opened = report.decisions().stream()
                .filter(decision ->
                        decision.prompt().equals(report.decisions().get(0).prompt()))
                .map(decision -> decision.openedAtMillis())
                .toList();
        long first = opened.get(0);
        assertThat(opened.get(1) - first).isBetween(90_500L, 90_700L);
        assertThat(opened.get(2) - first).isBetween(3_600_000L, 3_600_200L);
    }

    @Test
    void abortOfOneMissionIsTheOutcomeThoughAnotherEnded() {
        InProcessRun run =
                new InProcessRun(PLAN, SETTINGS.withAlso(List.of("clv@1")), AnswersFile.EMPTY, RunJournal.none());
        run.session().scheduler().at(60_000, () -> run.session().abort(2));

        RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ABORTED);
        assertThat(report.firings()).anyMatch(firing -> firing.mission() == 1 && firing.atMillis() > 60_000);
    }

    @Test
    void runThatIsTakenUpStartsTheMissionThatWasStillToCome() throws Exception {
        Path file = folder.resolve("journal");
        RunRecord record = new RunRecord(
                SETTINGS.withLimit(OptionalLong.of(40_000)),
                "clv",
                new ProjectWriter(TestRuns.LIBRARY.vocabulary()).text(PLAN.project()),
                TestRuns.LIBRARY.files().texts());
        try (WrittenJournal journal = WrittenJournal.create(file, record)) {
            new InProcessRun(PLAN, record.settings(), AnswersFile.EMPTY, journal).run(Pacer.UNPACED, RunObserver.NONE);
        }

        try (ResumedJournal journal = ResumedJournal.open(file)) {
            RunSettings read = journal.record().settings().withLimit(SETTINGS.limitMillis());
            RunReport resumed =
                    new InProcessRun(PLAN, read, AnswersFile.EMPTY, journal).run(Pacer.UNPACED, RunObserver.NONE);

            assertThat(read).isEqualTo(SETTINGS);
            assertThat(resumed.firings()).anyMatch(firing -> firing.mission() == 3);
            assertThat(resumed.result().runHash())
                    .isEqualTo(TestRuns.run(PLAN, SETTINGS).result().runHash());
        }
    }

    @Test
    void missionOfAPlanThatIsNotThereIsRefused() {
        CommandResult refused = CommandResult.crw("run", "clv", "--also", "search@60");
        CommandResult noTime = CommandResult.crw("run", "clv", "--also", "clv@soon");

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err()).contains("--also: the project has no plan 'search'; it has clv");
        assertThat(noTime.exitCode()).isEqualTo(2);
        assertThat(noTime.err()).contains("--also: 'soon' in 'clv@soon' is no number of seconds");
    }
}
