package org.sami.dreamm.learn;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.spn.protocol.Token;

class PictureRunTest {
    private final Course course = LearnerScene.course();

    @Test
    void aTestCaseIsPlayedForwardsAndBack() {
        PictureRun run = run("01-one", "play").orElseThrow();
        assertThat(run.all()).contains(2);
        assertThat(run.marking().at("start")).contains(Token.GENERIC);
        assertThat(run.next()).contains("5 s pass");

        run.forward();
        assertThat(run.marking().at("end")).contains(Token.GENERIC);
        assertThat(run.fired()).containsExactly("go");
        assertThat(run.isOver()).isTrue();
        run.forward();
        assertThat(run.hasNext()).isFalse();

        run.back();
        run.back();
        assertThat(run.steps()).isZero();
        assertThat(run.marking().at("start")).contains(Token.GENERIC);
        assertThat(run.fired()).isEmpty();
    }

    @Test
    void whoPlaysFreelyChoosesWhatHappens() {
        PictureRun run = run("01-one", "free").orElseThrow();
        assertThat(run.all()).isEmpty();
        assertThat(run.marking().at("start")).contains(new Token.Proxy("anna"));
        assertThat(run.choices()).contains("5 s pass");

        run.choose(run.choices().indexOf("5 s pass"));

        assertThat(run.isOver()).isTrue();
        assertThat(run.choices()).isEmpty();
    }

    @Test
    void aQuizPlaysItsRightAnswerAndATextRunsNothing() {
        assertThat(run("02-two", "after")).isPresent();
        assertThat(run("01-one", "places")).isEmpty();
    }

    private Optional<PictureRun> run(String lesson, String step) {
        Lesson in = course.lesson(lesson).orElseThrow();
        return StepRuns.of(
                course, LearnerScene.DOMAIN.vocabulary(), in, in.step(step).orElseThrow());
    }
}
