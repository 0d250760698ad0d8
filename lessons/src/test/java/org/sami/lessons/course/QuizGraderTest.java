package org.sami.lessons.course;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class QuizGraderTest {
    private final Course course = TestCourse.read();
    private final QuizGrader grader = new QuizGrader(course, TestCourse.DOMAIN.vocabulary());

    private Grade grade(String lesson, String step, Response response) {
        return grader.grade(course.lesson(lesson).orElseThrow(), TestCourse.quiz(course, lesson, step), response);
    }

    @Test
    void everyRightAnswerIsAccepted() {
        for (Lesson lesson : course.lessons()) {
            for (Step step : lesson.steps()) {
                if (step instanceof Step.Quiz quiz) {
                    Grade grade = grader.grade(lesson, quiz, grader.right(lesson, quiz));
                    assertThat(grade).isEqualTo(new Grade(true, List.of(quiz.solved())));
                }
            }
        }
    }

    @Test
    void aWrongChoiceIsToldWhyThatOneIsWrong() {
        assertThat(grade("01-one", "which", new Response.Choice(1)).words()).containsExactly("An edge is an arrow.");
    }

    @Test
    void ofSeveralEachThatIsMissingOrWrongIsExplained() {
        assertThat(grade("02-two", "several", new Response.Choices(Set.of(0, 2)))
                        .words())
                .containsExactly("Arrows are edges.", "Robots are on the water.");
    }

    @Test
    void markedElementsAreExplainedOneByOne() {
        assertThat(grade("01-one", "mark", new Response.Marks(Set.of("start", "go")))
                        .words())
                .containsExactly("A bar is a transition.", "An end place is a place.");
    }

    @Test
    void tokensAreWhereTheEnginePutsThem() {
        assertThat(grade("02-two", "after", new Response.Tokens(List.of(tokens("start", 1))))
                        .right())
                .isTrue();
        assertThat(grade("02-two", "after", new Response.Tokens(List.of(tokens("end", 1))))
                        .words())
                .containsExactly("The timer has not expired.");
        assertThat(grade("02-two", "after", new Response.Tokens(List.of())).words())
                .containsExactly("One token stands somewhere.");
    }

    @Test
    void aNumberHasItsOwnExplanation() {
        assertThat(grade("02-two", "how-many", new Response.Amount(2)).right()).isTrue();
        assertThat(grade("02-two", "how-many", new Response.Amount(3)).words()).containsExactly("The bar is no place.");
        assertThat(grade("02-two", "how-many", new Response.Amount(4)).words()).containsExactly("Count the circles.");
    }

    @Test
    void anAnswerOfAnotherFormIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> grade("01-one", "which", new Response.Amount(1)))
                .withMessageContaining("which");
    }

    private static TokensAt tokens(String place, int generic) {
        return new TokensAt(place, generic, List.of(), List.of());
    }
}
