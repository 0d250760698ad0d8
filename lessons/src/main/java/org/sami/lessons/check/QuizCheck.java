package org.sami.lessons.check;

import java.util.List;
import java.util.Optional;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.QuizQuestion;
import org.sami.lessons.course.QuizQuestion.Choice;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.TokensAfter;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TestCase;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.spn.vocabulary.Vocabulary;

/** Finds quizzes that leave a wrong answer without its reason, or whose right answer cannot be found out. */
final class QuizCheck {
    private final Course course;
    private final Vocabulary vocabulary;
    private final Lesson lesson;
    private final LessonProblems problems;

    QuizCheck(Course course, Vocabulary vocabulary, Lesson lesson, LessonProblems problems) {
        this.course = course;
        this.vocabulary = vocabulary;
        this.lesson = lesson;
        this.problems = problems;
    }

    void check(Step.Quiz quiz, String pointer) {
        if (course.address(lesson.id(), quiz.explained()).isEmpty()) {
            problems.add(
                    pointer + "/explained",
                    "there is no step \"" + quiz.explained() + "\" that explains the quiz \"" + quiz.id() + "\"");
        }
        if (quiz.solved().isBlank()) {
            problems.add(pointer + "/solved", "the quiz \"" + quiz.id() + "\" does not say what is so");
        }
        quiz.play().ifPresent(name -> plays(quiz, name, pointer + "/play"));
        QuizQuestion ask = quiz.ask();
        if (ask instanceof QuizQuestion.One one) {
            choices(one.choices(), false, pointer);
        } else if (ask instanceof QuizQuestion.Several several) {
            choices(several.choices(), true, pointer);
        } else if (ask instanceof QuizQuestion.Mark mark) {
            mark(quiz, mark, pointer);
        } else if (ask instanceof QuizQuestion.Tokens tokens) {
            tokens(quiz, tokens, pointer);
        }
    }

    private void choices(List<Choice> choices, boolean isRightExplained, String pointer) {
        for (int i = 0; i < choices.size(); i++) {
            if (choices.get(i).why().isBlank()
                    && (isRightExplained || !choices.get(i).right())) {
                problems.add(
                        pointer + "/ask/choices/" + i,
                        "the choice \"" + choices.get(i).text() + "\" has no \"why\"");
            }
        }
    }

    private void mark(Step.Quiz quiz, QuizQuestion.Mark mark, String pointer) {
        plan(quiz, pointer).ifPresent(plan -> {
            PictureCheck.elements(plan, mark.right(), pointer + "/ask/right", problems);
            PictureCheck.elements(plan, mark.why().keySet(), pointer + "/ask/why", problems);
            PictureCheck.elements(plan, mark.missing().keySet(), pointer + "/ask/missing", problems);
        });
    }

    private void tokens(Step.Quiz quiz, QuizQuestion.Tokens ask, String pointer) {
        plan(quiz, pointer).ifPresent(plan -> {
            for (int i = 0; i < ask.why().size(); i++) {
                String at = pointer + "/ask/why/" + i;
                ask.why().get(i).tokens().forEach(tokens -> PictureCheck.place(plan, tokens, at, problems));
            }
            try {
                TokensAfter.of(
                        course.project(lesson.id(), quiz.picture().orElseThrow().plan())
                                .orElseThrow(),
                        vocabulary,
                        plan,
                        ask.testCase(),
                        ask.steps());
            } catch (IllegalArgumentException wrong) {
                problems.add(pointer + "/ask", String.valueOf(wrong.getMessage()));
            }
        });
    }

    private Optional<Plan> plan(Step.Quiz quiz, String pointer) {
        if (quiz.picture().isEmpty()) {
            problems.add(pointer, "the quiz \"" + quiz.id() + "\" asks about a picture and has none");
        }
        return quiz.picture().flatMap(picture -> course.plan(lesson.id(), picture.plan()));
    }

    private void plays(Step.Quiz quiz, String name, String pointer) {
        Optional<String> reference = quiz.picture().map(picture -> picture.plan());
        if (reference.isEmpty()) {
            problems.add(pointer, "the quiz \"" + quiz.id() + "\" plays on a picture and has none");
        } else {
            testCase(reference.get(), name, pointer);
        }
    }

    /** The plan has the test case, and goes as it says. */
    void testCase(String reference, String name, String pointer) {
        Optional<Plan> plan = course.plan(lesson.id(), reference);
        if (plan.isEmpty()) {
            problems.add(pointer, "there is no plan \"" + reference + "\"");
            return;
        }
        Optional<TestCase> test = plan.get().testCases().stream()
                .filter(each -> each.name().equals(name))
                .findFirst();
        if (test.isEmpty()) {
            problems.add(pointer, "the plan \"" + reference + "\" has no test case \"" + name + "\"");
            return;
        }
        new TestCaseRunner(course.project(lesson.id(), reference).orElseThrow(), vocabulary)
                .run(plan.get(), test.get())
                .ifPresent(failure -> problems.add(pointer, failure.message()));
    }
}
