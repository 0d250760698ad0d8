package org.sami.crw.cli.lesson;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.progress.LearnerProgress;
import org.sami.lessons.progress.Learners;

/** {@code crw lessons} and {@code crw grade}. */
class LessonCommandsTest {
    private static final String PLANS = "../lessons/src/main/resources/org/sami/lessons/course/02-places/plans/";
    private static final String COURSE = "../lessons/src/test/resources/org/sami/lessons/course-of-jobs";

    @TempDir
    Path folder;

    @Test
    void aRightPlanPasses() {
        CommandResult grade = CommandResult.crw("grade", "02-places/visit-buoy", PLANS + "visit-1.json");

        assertThat(grade.exitCode()).as(grade.err()).isZero();
        assertThat(grade.out()).startsWith("passed: That is right");
    }

    @Test
    void aWrongPlanIsToldWhatIsWrongAndWhichStepExplainsIt() {
        CommandResult grade = CommandResult.crw("grade", "02-places/add-picture", PLANS + "picture-0.json");

        assertThat(grade.exitCode()).isEqualTo(1);
        assertThat(grade.out())
                .startsWith("not passed: There is no new place yet.")
                .contains("explained in 02-places/show-add");
    }

    @Test
    void aFailedCaseIsShownAsARunAlsoOfACourseOfOnesOwn() throws IOException {
        String start = COURSE + "/01-jobs/plans/gather-0.json";

        CommandResult grade = CommandResult.crw("grade", "--course", COURSE, "01-jobs/gather", start, "--json");

        assertThat(grade.exitCode()).isEqualTo(1);
        JsonNode verdict = new ObjectMapper().readTree(grade.out());
        assertThat(verdict.get("passed").booleanValue()).isFalse();
        assertThat(verdict.get("words").textValue()).isEqualTo("Nothing ends the mission when all are there.");
        assertThat(verdict.get("explained").textValue()).isEqualTo("01-jobs/all");
        assertThat(verdict.get("failedCase").textValue()).isEqualTo("three robots");
        assertThat(verdict.get("steps").size()).isGreaterThan(4);
    }

    @Test
    void whatCannotBeReadIsNamedAndIsNoVerdict() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.json"), "{\"formatVersion\": 1,\n oops}");
        Path large = Files.writeString(folder.resolve("large.json"), " ".repeat(5 << 20));

        CommandResult text = CommandResult.crw("grade", "02-places/visit-buoy", broken.toString());
        CommandResult size = CommandResult.crw("grade", "02-places/visit-buoy", large.toString());
        CommandResult none = CommandResult.crw("grade", "02-places/visit-buoy", folder + "/none.json");
        CommandResult job = CommandResult.crw("grade", "02-places/fly", PLANS + "visit-1.json");
        CommandResult name = CommandResult.crw("grade", "visit-buoy", PLANS + "visit-1.json");

        assertThat(text.exitCode()).isEqualTo(2);
        assertThat(text.err()).contains("broken.json:2:");
        assertThat(size.exitCode()).isEqualTo(2);
        assertThat(size.err()).contains("larger than 1 MB");
        assertThat(none.exitCode()).isEqualTo(2);
        assertThat(job.exitCode()).isEqualTo(2);
        assertThat(job.err()).contains("there is no job '02-places/fly'; the course has 02-places/add-picture");
        assertThat(name.exitCode()).isEqualTo(2);
        assertThat(name.err()).contains("LESSON/JOB");
    }

    @Test
    void lessonsAreListedWithTheirSteps() {
        CommandResult all = CommandResult.crw("lessons");
        CommandResult one = CommandResult.crw("lessons", "02-places");
        CommandResult none = CommandResult.crw("lessons", "20-flying");

        assertThat(all.out()).contains("01-motivation", "Lesson 2: Places and transitions (", "2 jobs)");
        assertThat(one.out()).contains("crw grade 02-places/visit-buoy FILE", "places", "Places");
        assertThat(none.exitCode()).isEqualTo(2);
        assertThat(none.err()).contains("there is no lesson '20-flying'");
    }

    @Test
    void learnersAreListedWithWhatTheyHaveDone() throws IOException {
        LearnerProgress ada = LearnerProgress.of("ada")
                .begun("01-motivation", LocalDate.of(2026, 1, 2))
                .read(new StepAddress("01-jobs", "all"));
        new Learners(folder).keep(ada);

        CommandResult listed = CommandResult.crw("lessons", "--course", COURSE, "--learners", folder.toString());
        CommandResult csv = CommandResult.crw("lessons", "--course", COURSE, "--learners", folder.toString(), "--csv");

        assertThat(listed.exitCode()).as(listed.err()).isZero();
        assertThat(listed.out()).startsWith("ada").contains("0 of 1 lessons, 1 of 3 steps");
        assertThat(csv.out()).contains("ada");
    }

    @Test
    void aCourseOfOnesOwnIsChecked() throws IOException {
        Path copy = folder.resolve("course");
        try (var files = Files.walk(Path.of(COURSE))) {
            for (Path file : (Iterable<Path>) files::iterator) {
                Path to = copy.resolve(Path.of(COURSE).relativize(file).toString());
                Files.createDirectories(to.getParent());
                if (Files.isRegularFile(file)) {
                    Files.copy(file, to);
                }
            }
        }
        Path job = copy.resolve("01-jobs/jobs/gather.json");
        Files.writeString(
                job,
                Files.readString(job)
                        .replace("\"start\": \"gather-0\"", "\"start\": \"gather\"")
                        .replace("\"explained\": \"all\"", "\"explained\": \"everything\""));

        CommandResult check = CommandResult.crw("lessons", "--check", "--course", copy.toString());

        assertThat(check.exitCode()).isEqualTo(1);
        assertThat(check.out())
                .contains(
                        "gather.json:1:1",
                        "The plan that the learner starts with passes already",
                        "\"everything\" is no step",
                        "1 lesson, 2 jobs: 2 findings");
    }

    @Test
    void whatALessonHidesIsWrittenAsAProfile() {
        CommandResult profile = CommandResult.crw("lessons", "02-places", "--profile");
        CommandResult whose = CommandResult.crw("lessons", "--profile");

        assertThat(profile.exitCode()).isZero();
        assertThat(profile.out()).startsWith("{").contains("\"formatVersion\" : 1", "\"panel-issues\"");
        assertThat(whose.exitCode()).isEqualTo(2);
        assertThat(whose.err()).contains("--profile goes with a LESSON");
    }

    @Test
    void optionsThatWouldBeIgnoredAreRefused() {
        CommandResult csv = CommandResult.crw("lessons", "--csv");
        CommandResult both = CommandResult.crw("lessons", "02-places", "--check");

        assertThat(csv.exitCode()).isEqualTo(2);
        assertThat(csv.err()).contains("--csv goes with --learners");
        assertThat(both.exitCode()).isEqualTo(2);
        assertThat(both.err()).contains("LESSON and --check do not go together");
    }

    @Test
    void aLearnerWhoseProgressIsBrokenIsNamedAndTheOthersAreListed() throws IOException {
        new Learners(folder).keep(LearnerProgress.of("ada"));
        Path broken = folder.resolve("bob/progress.json");
        Files.createDirectories(folder.resolve("bob"));
        Files.writeString(broken, "{\"formatVersion\": 1,\n oops}");

        CommandResult listed = CommandResult.crw("lessons", "--course", COURSE, "--learners", folder.toString());

        assertThat(listed.exitCode()).isZero();
        assertThat(listed.out()).startsWith("ada").doesNotContain("bob");
        assertThat(listed.err()).contains("bob/progress.json:2:");
        assertThat(broken).hasContent("{\"formatVersion\": 1,\n oops}");
    }

    @Test
    void aFolderIsNoPlan() {
        CommandResult grade = CommandResult.crw("grade", "02-places/visit-buoy", folder.toString());

        assertThat(grade.exitCode()).isEqualTo(2);
        assertThat(grade.err()).contains("is a folder");
    }
}
