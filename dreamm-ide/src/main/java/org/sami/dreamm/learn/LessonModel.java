package org.sami.dreamm.learn;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.Grade;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.QuizGrader;
import org.sami.lessons.course.Step;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Where a learner is in the course, and what was answered. It outlives the windows, which are opened again with each lesson. Used by one thread.
 */
public final class LessonModel {
    private final Course course;
    private final Vocabulary vocabulary;
    private final LearnerRecord record;
    private final QuizGrader grader;
    private final List<LessonListener> listeners = new CopyOnWriteArrayList<>();
    private final Map<StepAddress, QuizModel> quizzes = new HashMap<>();
    private Lesson lesson;
    private int index;

    /**
     * The course at the step where a learner was last, or at its beginning.
     *
     * @param vocabulary of the whole domain
     * @throws IllegalArgumentException if the course has no lesson with steps
     */
    public LessonModel(Course course, Vocabulary vocabulary, LearnerRecord record) {
        this.course = Objects.requireNonNull(course, "course");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.record = Objects.requireNonNull(record, "record");
        grader = new QuizGrader(course, vocabulary);
        StepAddress begin = record.resume(course)
                .orElseThrow(() -> new IllegalArgumentException("the course has no lesson that can be read"));
        lesson = course.lesson(begin.lesson()).orElseThrow();
        index = indexOf(lesson, begin.step());
        record.at(address());
    }

    private static int indexOf(Lesson lesson, String step) {
        return lesson.steps().stream().map(Step::id).toList().indexOf(step);
    }

    /** The course. */
    public Course course() {
        return course;
    }

    /** The words of the whole domain. */
    public Vocabulary vocabulary() {
        return vocabulary;
    }

    /** What is kept of the learner. */
    public LearnerRecord record() {
        return record;
    }

    /** The lesson that is taken. */
    public Lesson lesson() {
        return lesson;
    }

    /** The step that is shown. */
    public Step step() {
        return lesson.steps().get(index);
    }

    /** The number of the step in its lesson, from 0. */
    public int index() {
        return index;
    }

    /** Where the learner is. */
    public StepAddress address() {
        return new StepAddress(lesson.id(), step().id());
    }

    /** The quiz of the step that is shown; empty where it is none. */
    public Optional<QuizModel> quiz() {
        return step() instanceof Step.Quiz quiz
                ? Optional.of(quizzes.computeIfAbsent(
                        address(), address -> new QuizModel(lesson, quiz, grader, seed(address))))
                : Optional.empty();
    }

    private long seed(StepAddress address) {
        return Objects.hash(record.learner(), address.toString());
    }

    /** Whether a step is done: read, answered, or its job passed. */
    public boolean isDone(StepAddress step) {
        return record.on(step).done();
    }

    /** How many steps of a lesson are done. */
    public int done(Lesson of) {
        return (int) of.steps().stream()
                .filter(each -> isDone(new StepAddress(of.id(), each.id())))
                .count();
    }

    // ---- Going

    /** Whether there is a step after this one, in this lesson or the next. */
    public boolean hasNext() {
        return index + 1 < lesson.steps().size() || next().isPresent();
    }

    /** The lesson after this one that has steps. */
    private Optional<Lesson> next() {
        return course.after(lesson.id()).filter(after -> !after.steps().isEmpty());
    }

    /** Whether the next step is the first of another lesson. */
    public boolean isLastOfLesson() {
        return index + 1 >= lesson.steps().size();
    }

    /** Whether there is a step before this one. */
    public boolean hasBack() {
        return index > 0 || before().isPresent();
    }

    private Optional<Lesson> before() {
        return course.before(lesson.id()).filter(before -> !before.steps().isEmpty());
    }

    /** Goes on. What is only to be read, looked at or played is done then. */
    public void forward() {
        if (!(step() instanceof Step.Quiz) && !(step() instanceof Step.Job)) {
            setDone();
        }
        if (!isLastOfLesson()) {
            show(lesson, index + 1);
        } else {
            next().ifPresentOrElse(next -> show(next, 0), () -> tell(false));
        }
    }

    /** Goes back. */
    public void back() {
        if (index > 0) {
            show(lesson, index - 1);
        } else {
            before().ifPresent(before -> show(before, before.steps().size() - 1));
        }
    }

    /** Goes to a step of the course; one that the course does not have changes nothing. */
    public void go(StepAddress to) {
        course.lesson(to.lesson())
                .filter(there -> there.step(to.step()).isPresent())
                .ifPresent(there -> show(there, indexOf(there, to.step())));
    }

    private void show(Lesson there, int step) {
        boolean another = !there.id().equals(lesson.id());
        if (!another && step == index) {
            return;
        }
        lesson = there;
        index = step;
        record.at(address());
        tell(another);
    }

    private void tell(boolean anotherLesson) {
        if (anotherLesson) {
            listeners.forEach(LessonListener::lessonChanged);
        } else {
            listeners.forEach(LessonListener::stepChanged);
        }
    }

    // ---- Answering

    /** Grades the answer to the quiz that is shown. */
    public Grade check() {
        QuizModel quiz = quiz().orElseThrow(() -> new IllegalStateException("this step asks nothing"));
        Grade grade = quiz.check();
        record.attempted(address(), grade.right());
        changed();
        return grade;
    }

    /** Shows the right answer to the quiz that is shown. */
    public void reveal() {
        quiz().ifPresent(quiz -> {
            quiz.reveal();
            record.solved(address());
            setDone();
            changed();
        });
    }

    /** The plan of the job that is shown was checked. */
    public void checkedJob(StepAddress job, boolean passed) {
        record.attempted(job, passed);
        changed();
    }

    private void setDone() {
        record.read(address());
    }

    /** Tells the views that something about the step has changed. */
    public void changed() {
        listeners.forEach(LessonListener::changed);
    }

    /** Adds somebody who shows it. */
    public void addListener(LessonListener listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    /** Tells somebody no longer. */
    public void removeListener(LessonListener listener) {
        listeners.remove(listener);
    }
}
