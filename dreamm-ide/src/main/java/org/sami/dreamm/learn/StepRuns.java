package org.sami.dreamm.learn;

import java.util.Optional;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Step;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.vocabulary.Vocabulary;

/** Which plan runs in the picture of a step: that of a step to play, and that which shows the right answer to a quiz. */
public final class StepRuns {
    private StepRuns() {}

    /** The reference of the plan that a step draws: that of its picture, else the one that it plays. */
    public static Optional<String> plan(Step step) {
        return step instanceof Step.Play play
                ? Optional.of(play.plan())
                : step.picture().map(picture -> picture.plan());
    }

    /**
     * The run of a step, at its start; empty where the step runs nothing, or names a test case that its plan does not have.
     *
     * @throws IllegalArgumentException with the reason if the plan cannot start
     */
    public static Optional<PictureRun> of(Course course, Vocabulary vocabulary, Lesson lesson, Step step) {
        Optional<String> reference = plan(step);
        Optional<Project> project = reference.flatMap(each -> course.project(lesson.id(), each));
        Optional<Plan> plan = reference.flatMap(each -> course.plan(lesson.id(), each));
        if (project.isEmpty() || plan.isEmpty()) {
            return Optional.empty();
        }
        if (step instanceof Step.Play play && play.testCase().isEmpty()) {
            return Optional.of(PictureRun.free(project.get(), vocabulary, plan.get(), play.robots()));
        }
        return played(step)
                .flatMap(name -> testCase(plan.get(), name))
                .map(test -> PictureRun.of(project.get(), vocabulary, plan.get(), test));
    }

    private static Optional<String> played(Step step) {
        if (step instanceof Step.Play play) {
            return play.testCase();
        }
        return step instanceof Step.Quiz quiz ? quiz.play() : Optional.empty();
    }

    private static Optional<TestCase> testCase(Plan plan, String name) {
        return plan.testCases().stream()
                .filter(test -> test.name().equals(name))
                .findFirst();
    }
}
