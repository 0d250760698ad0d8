package org.sami.lessons.job;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.Term;
import org.sami.spn.json.Reading;

/** What people of the first study stumbled over (thesis, 9.3.3 and 9.3.4) is in the course, as the table of docs/course.md says. */
class StudyErrorsTest {
    private static final Path PAGE = Path.of("..", "docs", "course.md");
    private static final Path ANSWERS = Path.of("src", "test", "resources", "org", "sami", "lessons", "solutions");
    private static final Course COURSE =
            CourseReader.read(CourseFiles.SHIPPED, JobCourse.DOMAIN).orThrow();
    private static final JobGrader GRADER = new JobGrader(COURSE, JobCourse.DOMAIN);

    /** One line of the table. */
    record Row(String error, String quiz, String job, String answer) {}

    static Stream<Row> rows() throws IOException {
        List<Row> rows = Files.readAllLines(PAGE).stream()
                .dropWhile(line -> !line.startsWith("| what went wrong"))
                .skip(2)
                .takeWhile(line -> line.startsWith("|"))
                .map(line -> line.replace("`", "").split("\\|"))
                .map(cells -> new Row(cells[1].strip(), cells[2].strip(), cells[3].strip(), cells[4].strip()))
                .toList();
        assertThat(rows).hasSizeGreaterThanOrEqualTo(13);
        return rows.stream();
    }

    private static Optional<Step> step(String address) {
        return COURSE.lesson(address.substring(0, address.indexOf('/'))).stream()
                .flatMap(lesson -> lesson.steps().stream())
                .filter(step -> step.id().equals(address.substring(address.indexOf('/') + 1)))
                .findFirst();
    }

    @ParameterizedTest
    @MethodSource("rows")
    void anErrorOfTheStudyHasAQuizAJobAndADiagnosisOfItsOwn(Row row) throws IOException {
        assertThat(step(row.quiz())).get().isInstanceOf(Step.Quiz.class);
        String lesson = row.job().substring(0, row.job().indexOf('/'));
        Job job = JobReader.read(
                        COURSE, lesson, row.job().substring(lesson.length() + 1), JobCourse.DOMAIN.vocabulary())
                .orThrow();
        Path file = ANSWERS.resolve(row.job()).resolve(row.answer() + ".json");
        Reading<AnswerFile> answer = AnswerFile.read(file, lesson, job, GRADER, JobCourse.DOMAIN.vocabulary());

        Verdict verdict = GRADER.grade(lesson, job, answer.orThrow().project());

        assertThat(verdict.passed()).isFalse();
        assertThat(job.mistakes()).extracting(Job.Mistake::say).contains(verdict.words());
        assertThat(verdict.explained()).isPresent();
        assertThat(verdict.words()).contains(answer.orThrow().says());
    }

    @ParameterizedTest
    @ValueSource(strings = {"system", "runtime", "variable field", "looping"})
    void aWordThatPeopleAskedForIsInTheGlossary(String word) {
        assertThat(COURSE.terms())
                .filteredOn(term -> term.term().equals(word) || term.also().contains(word))
                .singleElement()
                .extracting(Term::text)
                .asString()
                .isNotBlank();
    }

    @Test
    void allHaveIsTaughtThreeTimesBeforeItIsNeeded() {
        List<String> jobs = List.copyOf(COURSE.jobs().keySet());

        assertThat(jobs)
                .containsSubsequence(
                        "07-operator/all-answered",
                        "08-variables/arrived",
                        "09-tasks/finish",
                        "final-panoramas/panoramas-together");
    }
}
