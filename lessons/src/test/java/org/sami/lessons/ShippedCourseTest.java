package org.sami.lessons;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.lessons.check.CourseChecks;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Grade;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.QuizGrader;
import org.sami.lessons.course.QuizQuestion;
import org.sami.lessons.course.ReadingTime;
import org.sami.lessons.course.Response;
import org.sami.lessons.course.Step;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;

/** Walks the content of the course that ships. */
class ShippedCourseTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Reading<Course> READ = CourseReader.read(CourseFiles.SHIPPED, DOMAIN);

    static Stream<String> lessons() {
        return READ.orThrow().lessons().stream().map(Lesson::id);
    }

    @Test
    void everyFileCanBeRead() {
        assertThat(READ.findings()).extracting(ShippedCourseTest::words).isEmpty();
    }

    @Test
    void theChecksFindNothing() {
        assertThat(CourseChecks.check(READ.orThrow(), CourseFiles.SHIPPED, DOMAIN.vocabulary()))
                .extracting(ShippedCourseTest::words)
                .isEmpty();
    }

    private static String words(Finding finding) {
        return finding.location().map(SourceLocation::toString).orElse("") + " " + finding.elements() + ": "
                + finding.message();
    }

    @ParameterizedTest
    @MethodSource("lessons")
    void eachRightAnswerIsAcceptedAndEachWrongOneIsExplained(String id) {
        Course course = READ.orThrow();
        Lesson lesson = course.lesson(id).orElseThrow();
        QuizGrader grader = new QuizGrader(course, DOMAIN.vocabulary());
        for (Step step : lesson.steps()) {
            if (step instanceof Step.Quiz quiz) {
                Response right = grader.right(lesson, quiz);
                assertThat(grader.grade(lesson, quiz, right))
                        .as(quiz.id())
                        .isEqualTo(new Grade(true, List.of(quiz.solved())));
                for (Response wrong : wrong(quiz.ask(), right)) {
                    Grade grade = grader.grade(lesson, quiz, wrong);
                    assertThat(grade.right())
                            .as("%s answered by %s", quiz.id(), wrong)
                            .isFalse();
                    assertThat(grade.words()).as(quiz.id()).isNotEmpty().noneMatch(String::isBlank);
                }
            }
        }
    }

    /** Wrong answers to a question: each single wrong choice, each likely wrong marking or number, nothing at all. */
    private static List<Response> wrong(QuizQuestion ask, Response right) {
        if (ask instanceof QuizQuestion.One one) {
            return Stream.iterate(0, i -> i < one.choices().size(), i -> i + 1)
                    .filter(i -> !one.choices().get(i).right())
                    .<Response>map(Response.Choice::new)
                    .toList();
        } else if (ask instanceof QuizQuestion.Several several) {
            return Stream.iterate(0, i -> i < several.choices().size(), i -> i + 1)
                    .<Response>map(i -> turned((Response.Choices) right, i))
                    .toList();
        } else if (ask instanceof QuizQuestion.Mark) {
            return List.of(new Response.Marks(Set.of()));
        } else if (ask instanceof QuizQuestion.Tokens tokens) {
            return Stream.concat(
                            tokens.why().stream().map(each -> each.tokens()).map(Response.Tokens::new),
                            Stream.of(right)
                                    .map(Response.Tokens.class::cast)
                                    .filter(each -> !each.tokens().isEmpty())
                                    .map(each -> new Response.Tokens(List.of())))
                    .<Response>map(each -> each)
                    .toList();
        }
        QuizQuestion.Amount amount = (QuizQuestion.Amount) ask;
        return Stream.concat(amount.why().keySet().stream().map(Integer::valueOf), Stream.of(amount.right() + 1_000))
                .<Response>map(Response.Amount::new)
                .toList();
    }

    private static Response.Choices turned(Response.Choices right, int choice) {
        Set<Integer> other = new java.util.HashSet<>(right.indices());
        if (!other.remove(choice)) {
            other.add(choice);
        }
        return new Response.Choices(other);
    }

    @Test
    void theTenLessonsAndTheFinalPlansTakeLessThanThreeHours() {
        List<Lesson> first = READ.orThrow().lessons().stream()
                .filter(lesson -> lesson.number() <= 10)
                .toList();

        assertThat(first).extracting(Lesson::id).contains("final-panoramas", "final-exploration");
        assertThat(ReadingTime.of(first)).isLessThan(Duration.ofHours(3));
    }
}
