package org.sami.dreamm.learn;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.lessons.course.Course.StepAddress;

class LessonModelTest {
    @TempDir
    private Path folder;

    private LearnerScene scene;
    private LessonModel model;

    @BeforeEach
    void begin() {
        scene = new LearnerScene(folder);
        model = scene.model;
    }

    @AfterEach
    void close() {
        scene.record.close();
    }

    @Test
    void aLearnerBeginsAtTheFirstStepAndCannotGoBackFromIt() {
        assertThat(model.address()).isEqualTo(new StepAddress("01-one", "places"));
        assertThat(model.hasBack()).isFalse();

        model.back();

        assertThat(model.index()).isZero();
    }

    @Test
    void whatIsOnlyReadIsDoneOnceTheLearnerGoesOnAndAQuizIsNot() {
        model.forward();
        assertThat(model.isDone(new StepAddress("01-one", "places"))).isTrue();
        assertThat(model.step().id()).isEqualTo("which");

        model.forward();

        assertThat(model.isDone(new StepAddress("01-one", "which"))).isFalse();
        assertThat(model.done(model.lesson())).isEqualTo(1);
    }

    @Test
    void theLastStepLeadsToTheNextLessonAndBackAgain() {
        List<String> told = new ArrayList<>();
        model.addListener(new LessonListener() {
            @Override
            public void stepChanged() {
                told.add("step " + model.step().id());
            }

            @Override
            public void lessonChanged() {
                told.add("lesson " + model.lesson().id());
            }
        });
        model.go(new StepAddress("01-one", "free"));
        model.forward();
        model.back();

        assertThat(told).containsExactly("step free", "lesson 02-two", "lesson 01-one");
        assertThat(model.step().id()).isEqualTo("free");
    }

    @Test
    void aStepThatTheCourseDoesNotHaveChangesNothing() {
        model.go(new StepAddress("01-one", "nowhere"));
        model.go(new StepAddress("99-none", "places"));

        assertThat(model.step().id()).isEqualTo("places");
    }

    @Test
    void anotherWindowGoesOnWhereThisOneWas() {
        model.go(new StepAddress("02-two", "where"));
        model.forward();
        scene.record.close();

        LearnerScene next = new LearnerScene(folder);

        assertThat(next.model.address()).isEqualTo(new StepAddress("02-two", "after"));
        assertThat(next.model.isDone(new StepAddress("02-two", "where"))).isTrue();
        next.record.close();
    }

    @Test
    void timeCountsForTheStepThatWasShownAndAPauseOnlyInPart() throws IOException {
        scene.clock.set(4_000);
        model.forward();
        scene.clock.addAndGet(3 * 3_600_000L);
        model.back();
        scene.record.close();

        assertThat(scene.learners
                        .open("ada")
                        .progress()
                        .on(new StepAddress("01-one", "places"))
                        .millis())
                .isEqualTo(4_000);
        assertThat(scene.learners
                        .open("ada")
                        .progress()
                        .on(new StepAddress("01-one", "which"))
                        .millis())
                .isEqualTo(600_000);
    }

    @Test
    void aBrokenFileOfProgressIsSetAsideAndNamedAndTheCourseBeginsAnew() throws IOException {
        Path file = folder.resolve("bert").resolve("progress.json");
        Files.createDirectories(file.getParent());
        Files.writeString(file, "{\"formatVersion\": 1, \"learner\": ");

        LoadedCourse read = LoadedCourse.read(LearnerScene.FILES, LearnerScene.DOMAIN, scene.learners, "bert");

        assertThat(read.notes()).singleElement().asString().contains("bert", "progress-broken-1.json");
        assertThat(read.model().step().id()).isEqualTo("places");
        assertThat(folder.resolve("bert").resolve("progress-broken-1.json"))
                .hasContent("{\"formatVersion\": 1, \"learner\": ");
        read.model().record().close();
    }
}
