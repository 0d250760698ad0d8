package org.sami.lessons.job;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/** Walks the jobs of the course that ships: each is done by its solution, not by its start, and says of wrong answers what it should. */
@Execution(ExecutionMode.CONCURRENT)
class ShippedJobsTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Course COURSE =
            CourseReader.read(CourseFiles.SHIPPED, DOMAIN).orThrow();
    private static final JobGrader GRADER = new JobGrader(COURSE, DOMAIN);
    private static final Path ANSWERS = Path.of("src", "test", "resources", "org", "sami", "lessons", "solutions");

    static Stream<String> jobs() {
        return COURSE.jobs().keySet().stream();
    }

    private static String lesson(String name) {
        return name.substring(0, name.indexOf('/'));
    }

    private static Job job(String name) {
        Reading<Job> read =
                JobReader.read(COURSE, lesson(name), name.substring(name.indexOf('/') + 1), DOMAIN.vocabulary());
        assertThat(AnswerFile.errors(read)).as(name).isEmpty();
        return read.orThrow();
    }

    @ParameterizedTest
    @MethodSource("jobs")
    void theSolutionIsRightAndTheStartIsNot(String name) {
        Job job = job(name);
        Reading<Project> solution = GRADER.solution(lesson(name), job);
        assertThat(AnswerFile.errors(solution)).as(name).isEmpty();
        Verdict right = GRADER.grade(lesson(name), job, solution.orThrow());
        assertThat(right.passed()).as("%s: %s", name, right.words()).isTrue();
        Optional<Project> start = COURSE.project(lesson(name), job.start());
        assertThat(start).as("start of " + name).isPresent();
        Verdict empty = GRADER.grade(lesson(name), job, start.orElseThrow());
        assertThat(empty.passed()).as("start of " + name).isFalse();
        assertThat(empty.words()).isNotBlank();
    }

    static Stream<Path> answers() throws IOException {
        try (Stream<Path> files = Files.walk(ANSWERS)) {
            return files.filter(file -> file.toString().endsWith(".json")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("jobs")
    void aJobHasAtLeastThreeRightAndFiveWrongAnswers(String name) throws IOException {
        List<String> files;
        try (Stream<Path> all = Files.list(ANSWERS.resolve(name))) {
            files = all.map(file -> file.getFileName().toString()).toList();
        }

        assertThat(files).filteredOn(file -> file.startsWith("right-")).hasSizeGreaterThanOrEqualTo(3);
        assertThat(files).filteredOn(file -> file.startsWith("wrong-")).hasSizeGreaterThanOrEqualTo(5);
    }

    @ParameterizedTest
    @MethodSource("answers")
    void rightAnswersAreAcceptedAndWrongOnesAreExplained(Path file) throws IOException {
        String jobId = file.getParent().getFileName().toString();
        String lesson = file.getParent().getParent().getFileName().toString();
        Job job = job(lesson + "/" + jobId);
        Reading<AnswerFile> answer = AnswerFile.read(file, lesson, job, GRADER, DOMAIN.vocabulary());
        assertThat(AnswerFile.errors(answer)).as(file.toString()).isEmpty();
        Verdict verdict = GRADER.grade(lesson, job, answer.orThrow().project());
        boolean isRight = file.getFileName().toString().startsWith("right-");
        assertThat(verdict.passed()).as("%s: %s", file, verdict.words()).isEqualTo(isRight);
        assertThat(verdict.words())
                .as(file.toString())
                .contains(isRight ? "" : answer.orThrow().says());
    }

    @ParameterizedTest
    @MethodSource("jobs")
    void everyStepThatExplainsIsThere(String name) {
        Job job = job(name);
        List<String> unknown = Stream.concat(
                        job.uses().stream().flatMap(use -> use.explained().stream()),
                        job.mistakes().stream().flatMap(mistake -> mistake.explained().stream()))
                .filter(step -> COURSE.address(lesson(name), step).isEmpty())
                .toList();
        assertThat(unknown).as(name).isEmpty();
    }
}
