package org.sami.dreamm.learn;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.Grade;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.QuizGrader;
import org.sami.lessons.course.Step;
import org.sami.spn.protocol.Token;

class QuizModelTest {
    @TempDir
    private Path folder;

    private LearnerScene scene;

    @BeforeEach
    void begin() {
        scene = new LearnerScene(folder);
    }

    @AfterEach
    void close() {
        scene.record.close();
    }

    @Test
    void nothingIsCheckedBeforeSomethingIsChosen() {
        QuizModel quiz = scene.quiz("01-one", "which");

        assertThat(quiz.whyNotCheck()).contains("choose one first");
        assertThatThrownBy(quiz::check)
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("choose one first");
    }

    @Test
    void aWrongChoiceSaysWhyAndAnotherCanBeTakenWhoseRightnessIsDone() {
        QuizModel quiz = scene.quiz("01-one", "which");
        quiz.choose(1);
        Grade wrong = scene.model.check();

        assertThat(wrong.right()).isFalse();
        assertThat(wrong.words()).containsExactly("An edge is an arrow.");
        assertThat(quiz.isWrong()).isTrue();
        assertThat(quiz.whyNotCheck()).contains("this answer was checked: change it first");
        assertThat(done("01-one", "which")).isFalse();

        quiz.choose(0);
        Grade right = scene.model.check();

        assertThat(quiz.chosen()).containsExactly(0);
        assertThat(right).isEqualTo(new Grade(true, List.of("Places are circles.")));
        assertThat(done("01-one", "which")).isTrue();
        assertThat(scene.record.on(address("01-one", "which")).attempts()).isEqualTo(2);
        assertThat(scene.record.on(address("01-one", "which")).rightAtOnce()).isFalse();
    }

    @Test
    void whatIsAnsweredCannotBeChangedAnyMore() {
        QuizModel quiz = scene.quiz("01-one", "which");
        quiz.choose(0);
        scene.model.check();
        quiz.choose(1);

        assertThat(quiz.chosen()).containsExactly(0);
        assertThat(quiz.whyNotCheck()).contains("it is answered");
    }

    @Test
    void ofSeveralChoicesEachThatIsWrongOrMissingSaysWhy() {
        QuizModel quiz = scene.quiz("02-two", "several");
        quiz.choose(0);
        quiz.choose(2);
        assertThat(scene.model.check().words()).containsExactly("Arrows are edges.", "Robots are on the water.");

        quiz.choose(2);
        quiz.choose(1);
        assertThat(scene.model.check().right()).isTrue();
    }

    @Test
    void elementsAreMarkedAndUnmarked() {
        QuizModel quiz = scene.quiz("01-one", "mark");
        quiz.mark("start");
        quiz.mark("go");
        assertThat(scene.model.check().words()).containsExactly("A bar is a transition.", "An end place is a place.");

        quiz.mark("go");
        quiz.mark("end");
        assertThat(scene.model.check().right()).isTrue();
    }

    @Test
    void tokensBeginAsInThePictureAndAreMoved() {
        QuizModel quiz = scene.quiz("02-two", "after");
        assertThat(quiz.tokens().marking().at("start")).containsExactly(Token.GENERIC);
        assertThat(quiz.tokenKinds()).containsExactly(Token.GENERIC);

        quiz.clear("start");
        quiz.put("end", Token.GENERIC);
        assertThat(scene.model.check().words()).containsExactly("The timer has not expired.");

        quiz.clear("end");
        quiz.put("start", Token.GENERIC);
        assertThat(scene.model.check().right()).isTrue();
    }

    @Test
    void aRobotIsPutOnceIntoAPlaceAndTakenOutAgain() {
        TokenDraft draft = new TokenDraft(List.of());
        Token anna = new Token.Proxy("anna");
        draft.put("p", anna);
        draft.put("p", Token.GENERIC);
        draft.put("p", Token.GENERIC);
        assertThat(draft.tokens().get(0).generic()).isEqualTo(2);
        assertThat(draft.tokens().get(0).robots()).containsExactly("anna");

        draft.put("p", anna);
        assertThat(draft.tokens().get(0).robots()).isEmpty();
    }

    @Test
    void aNumberIsTyped() {
        QuizModel quiz = scene.quiz("02-two", "how-many");
        quiz.setNumber("two");
        assertThat(quiz.whyNotCheck()).contains("type a whole number first");

        quiz.setNumber(" 3 ");
        assertThat(scene.model.check().words()).containsExactly("The bar is no place.");

        quiz.setNumber("2");
        assertThat(scene.model.check().right()).isTrue();
    }

    @Test
    void theRightAnswerIsShownForEachKindOfQuiz() {
        QuizModel one = scene.quiz("01-one", "which");
        scene.model.reveal();
        assertThat(one.chosen()).containsExactly(0);
        QuizModel mark = scene.quiz("01-one", "mark");
        scene.model.reveal();
        assertThat(mark.marks()).containsExactlyInAnyOrder("start", "end");
        QuizModel several = scene.quiz("02-two", "several");
        scene.model.reveal();
        assertThat(several.chosen()).containsExactlyInAnyOrder(0, 1);
        QuizModel number = scene.quiz("02-two", "how-many");
        scene.model.reveal();
        assertThat(number.number()).isEqualTo("2");
        QuizModel tokens = scene.quiz("02-two", "after");
        tokens.clear("start");
        scene.model.reveal();
        assertThat(tokens.tokens().marking().at("start")).containsExactly(Token.GENERIC);

        assertThat(tokens.isClosed()).isTrue();
        assertThat(scene.record.on(address("02-two", "after")).solutionSeen()).isTrue();
        assertThat(done("02-two", "after")).isTrue();
    }

    @Test
    void theOrderOfChoicesIsDrawnByTheSeedAlone() {
        Lesson lesson = LearnerScene.course().lesson("02-two").orElseThrow();
        Step.Quiz quiz = (Step.Quiz) lesson.step("several").orElseThrow();
        QuizGrader grader = new QuizGrader(LearnerScene.course(), LearnerScene.DOMAIN.vocabulary());

        Set<List<Integer>> orders = new HashSet<>();
        LongStream.range(0, 30).forEach(seed -> orders.add(new QuizModel(lesson, quiz, grader, seed).order()));

        assertThat(orders).hasSize(6);
        assertThat(new QuizModel(lesson, quiz, grader, 5).order())
                .isEqualTo(new QuizModel(lesson, quiz, grader, 5).order());
    }

    private boolean done(String lesson, String step) {
        return scene.model.isDone(address(lesson, step));
    }

    private static StepAddress address(String lesson, String step) {
        return new StepAddress(lesson, step);
    }
}
