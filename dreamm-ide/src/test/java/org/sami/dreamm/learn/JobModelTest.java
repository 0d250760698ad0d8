package org.sami.dreamm.learn;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.file.ReplaceProject;
import org.sami.dreamm.learn.JobModel.Help;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.job.JobGrader;
import org.sami.lessons.job.Verdict;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;

class JobModelTest {
    private static final StepAddress JOB = new StepAddress("02-two", "job");

    @TempDir
    private Path folder;

    private final List<Runnable> work = new ArrayList<>();
    private LearnerScene scene;
    private TestJobEditor editor;
    private JobModel jobs;

    /** An editor without a window and without a panel to try plans in. */
    private static final class TestJobEditor implements JobEditor {
        private final ProjectDocument document = new ProjectDocument(
                LearnerScene.DOMAIN.vocabulary(),
                new Project("none", "", "crw", List.of(), List.of(), List.of()),
                Optional.empty());
        private Optional<Plan> compared = Optional.empty();

        @Override
        public void open(Path file, Project begin) {
            document.open(begin, Optional.of(file));
        }

        @Override
        public void replace(String label, Project by) {
            document.apply(new ReplaceProject(label, by));
        }

        @Override
        public Project project() {
            return document.project();
        }

        @Override
        public void show(String plan, Set<String> elements) {
            // there is nothing to see
        }

        @Override
        public boolean play(String plan, TestCase run) {
            return false;
        }

        @Override
        public void compareWithSolution(Plan solution) {
            compared = Optional.of(solution);
        }
    }

    @BeforeEach
    void begin() {
        scene = new LearnerScene(folder);
        editor = new TestJobEditor();
        JobGrader grader = new JobGrader(scene.model.course(), LearnerScene.DOMAIN);
        jobs = new JobModel(scene.model, grader, editor, work::add, Runnable::run);
        jobs.showStep();
        scene.model.go(JOB);
        jobs.showStep();
    }

    @AfterEach
    void close() {
        scene.record.close();
    }

    private void solve() {
        editor.replace("Solve", scene.model.course().project("01-one", "wait").orElseThrow());
    }

    private void runWork() {
        List<Runnable> now = List.copyOf(work);
        work.clear();
        now.forEach(Runnable::run);
    }

    @Test
    void thePlanOfTheJobIsOpenedFromTheFileOfTheLearner() {
        assertThat(editor.project()
                        .plan("wait")
                        .orElseThrow()
                        .place("end")
                        .orElseThrow()
                        .end())
                .isFalse();
        assertThat(editor.document.file()).contains(folder.resolve("ada/jobs/02-two/end.json"));
    }

    @Test
    void aWrongPlanIsToldWhyAndItsRunIsPlayedAndARightOneIsDone() {
        jobs.check();
        assertThat(jobs.isChecking()).isTrue();
        runWork();

        Verdict wrong = jobs.verdict().orElseThrow();
        assertThat(wrong.passed()).isFalse();
        assertThat(wrong.words()).contains("With one robot the mission never ends");
        PictureRun failed = jobs.play().orElseThrow();
        failed.forward();
        assertThat(failed.isOver()).isFalse();
        assertThat(scene.record.on(JOB).attempts()).isEqualTo(1);

        solve();
        assertThat(jobs.isOutdated()).isTrue();
        jobs.check();
        runWork();

        assertThat(jobs.verdict().orElseThrow().passed())
                .as(jobs.verdict().toString())
                .isTrue();
        assertThat(scene.model.isDone(JOB)).isTrue();
        assertThat(jobs.run()).isEmpty();
    }

    @Test
    void whatIsCancelledSaysNothing() {
        jobs.check();
        jobs.cancel();
        runWork();

        assertThat(jobs.isChecking()).isFalse();
        assertThat(jobs.verdict()).isEmpty();
        assertThat(scene.record.on(JOB).attempts()).isZero();
    }

    @Test
    void helpComesStepByStepAndTheSolutionLast() {
        for (int i = 0; i < 5; i++) {
            jobs.showHelp();
        }

        assertThat(jobs.help()).containsExactly(Help.HINT, Help.STRONGER, Help.EXAMPLE, Help.SOLUTION);
        assertThat(jobs.nextHelp()).isEmpty();
        assertThat(scene.record.on(JOB).hints()).isEqualTo(3);
        assertThat(scene.record.on(JOB).solutionSeen()).isTrue();
        assertThat(editor.compared.orElseThrow().place("end").orElseThrow().end())
                .isTrue();
        assertThat(jobs.example()).isPresent();
    }

    @Test
    void aJobIsBegunAnewAndThatIsTakenBack() {
        solve();
        jobs.startOver();
        assertThat(editor.project()
                        .plan("wait")
                        .orElseThrow()
                        .place("end")
                        .orElseThrow()
                        .end())
                .isFalse();

        editor.document.undo();
        assertThat(editor.project()
                        .plan("wait")
                        .orElseThrow()
                        .place("end")
                        .orElseThrow()
                        .end())
                .isTrue();
    }

    @Test
    void besideAnotherStepThePlanStaysThatWasOpen() {
        Project before = editor.project();
        scene.model.back();
        jobs.showStep();

        assertThat(editor.project()).isEqualTo(before);
        assertThat(jobs.job()).isEmpty();
        assertThat(jobs.whyNotCheck()).contains("this step has no job");
    }
}
