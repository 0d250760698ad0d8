package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TaskResult;
import org.sami.crw.report.file.ReportFolder;
import org.sami.crw.report.file.ReportJson;
import org.sami.crw.sim.run.settings.RunPlan;

/** A plan of tasks on simulated boats, and what is reported of the tasks. */
class TaskRunTest {
    private static final RunPlan PLAN = TestRuns.plan("measure");

    @TempDir
    Path folder;

    @Test
    void everyTaskIsDoneByOneBoatAfterAnother() {
        RunReport report = TestRuns.run(PLAN, TestRuns.settings(PLAN, 3, 9, 4));

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.tasks()).hasSize(9).allSatisfy(task -> {
            assertThat(task.isComplete()).as(task.task()).isTrue();
            assertThat(task.allocations()).as(task.task()).isEqualTo(1);
            assertThat(task.location()).isPresent();
        });
        assertThat(report.locationsVisited()).isEqualTo(9);
        report.tasks().stream().collect(Collectors.groupingBy(TaskResult::boat)).forEach(TaskRunTest::assertInTurn);
    }

    /** A boat begins with a task when the one before is complete. */
    private static void assertInTurn(String boat, List<TaskResult> tasks) {
        List<TaskResult> inOrder = tasks.stream()
                .sorted((a, b) -> Long.compare(
                        a.startedAtMillis().getAsLong(), b.startedAtMillis().getAsLong()))
                .toList();
        for (int i = 1; i < inOrder.size(); i++) {
            assertThat(inOrder.get(i).startedAtMillis().getAsLong())
                    .as(boat + ", " + inOrder.get(i).task())
                    .isGreaterThanOrEqualTo(
                            inOrder.get(i - 1).completedAtMillis().getAsLong());
        }
    }

    @Test
    void equalSeedsGiveEqualTasks() {
        RunReport one = TestRuns.run(PLAN, TestRuns.settings(PLAN, 2, 5, 8));
        RunReport other = TestRuns.run(PLAN, TestRuns.settings(PLAN, 2, 5, 8));

        assertThat(other.tasks()).isEqualTo(one.tasks());
        assertThat(other.result().runHash()).isEqualTo(one.result().runHash());
    }

    @Test
    void theReportTellsOfEachTask() throws IOException {
        RunReport report = TestRuns.run(PLAN, TestRuns.settings(PLAN, 2, 3, 8));

        new ReportFolder(folder).write(report);

        assertThat(Files.readAllLines(folder.resolve("tasks.csv")))
                .hasSize(4)
                .first()
                .asString()
                .isEqualTo("mission,task,lat_deg,lon_deg,boat,allocations,started_at_s,completed_at_s");
        assertThat(new ObjectMapper()
                        .readTree(ReportJson.text(report))
                        .get("tasks")
                        .findValuesAsText("complete"))
                .containsExactly("true", "true", "true");
        assertThat(ReportText.text(report)).contains("tasks: 3 of 3 complete").contains("Temperature 3");
    }

    @Test
    void tasksOfARunThatWasStoppedAreNotComplete() {
        RunReport report = TestRuns.run(PLAN, TestRuns.settings(PLAN, 1, 6, 8).withLimit(OptionalLong.of(60_000)));

        assertThat(report.tasks()).hasSize(6);
        assertThat(report.tasks()).anyMatch(task -> task.startedAtMillis().isEmpty());
        assertThat(ReportText.text(report)).contains("(not complete)");
    }
}
