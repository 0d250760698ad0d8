package org.sami.dreamm.learn;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.progress.Learners;
import org.sami.spn.json.DomainLibrary;

/** A learner in the small course of the tests: two lessons with each kind of quiz. */
final class LearnerScene {
    static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    static final CourseFiles FILES = CourseFiles.onClassPath("org/sami/dreamm/learn/course");

    final AtomicLong clock = new AtomicLong();
    final Learners learners;
    final LearnerRecord record;
    final LessonModel model;

    LearnerScene(Path folder) {
        learners = new Learners(folder);
        record = open(learners, clock);
        model = new LessonModel(course(), DOMAIN.vocabulary(), record);
    }

    private static LearnerRecord open(Learners learners, AtomicLong clock) {
        try {
            return new LearnerRecord(learners, learners.open("ada").progress(), clock::get);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    static Course course() {
        return CourseReader.read(FILES, DOMAIN).orThrow();
    }

    /** Goes to a step and gives its quiz. */
    QuizModel quiz(String lesson, String step) {
        model.go(new StepAddress(lesson, step));
        return model.quiz().orElseThrow();
    }
}
