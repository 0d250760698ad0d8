package org.sami.lessons.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Finds what a lesson's plans use before a lesson introduces it, and what a lesson introduces that the domain lacks. */
final class UseCheck {
    private UseCheck() {}

    static void introduced(Vocabulary vocabulary, Lesson lesson, LessonProblems problems) {
        unknown(lesson.events(), name -> vocabulary.event(name).isPresent(), "/events/", "event", problems);
        unknown(lesson.tasks(), vocabulary.taskClasses()::containsKey, "/tasks/", "class of tasks", problems);
        unknown(lesson.markups(), vocabulary.markups()::containsKey, "/markups/", "markup", problems);
    }

    private static void unknown(
            List<String> names, Predicate<String> known, String pointer, String what, LessonProblems problems) {
        for (int i = 0; i < names.size(); i++) {
            if (!known.test(names.get(i))) {
                problems.add(pointer + i, "the domain has no " + what + " \"" + names.get(i) + "\"");
            }
        }
    }

    /** What a plan that a step names uses is known by then. */
    static void used(Course course, Lesson lesson, String reference, String pointer, LessonProblems problems) {
        Optional<Project> project = course.project(lesson.id(), reference);
        if (project.isEmpty()) {
            problems.add(pointer, "there is no plan \"" + reference + "\"");
            return;
        }
        used(course, lesson, project.get(), "the plan \"" + reference + "\"", pointer, problems);
    }

    /**
     * What the plans of a project use is known by then.
     *
     * @param what what to call the project
     */
    static void used(
            Course course, Lesson lesson, Project project, String what, String pointer, LessonProblems problems) {
        Set<String> events = course.eventsKnown(lesson.id());
        Set<String> tasks = course.tasksKnown(lesson.id());
        Set<String> markups = course.markupsKnown(lesson.id());
        for (Plan plan : project.plans()) {
            List<String> early = new ArrayList<>();
            plan.places()
                    .forEach(place -> place.outputs().forEach(event -> {
                        early(event.type(), events, early);
                        event.markups().stream().map(MarkupSpec::type).forEach(type -> early(type, markups, early));
                    }));
            plan.transitions()
                    .forEach(transition -> transition.inputs().forEach(event -> early(event.type(), events, early)));
            plan.tasks().forEach(task -> early(task.taskClass(), tasks, early));
            if (!early.isEmpty()) {
                problems.add(
                        pointer,
                        what + " uses "
                                + early.stream().distinct().collect(Collectors.joining(", "))
                                + ", which no lesson up to this one introduces");
            }
        }
    }

    private static void early(String name, Set<String> known, List<String> early) {
        if (!known.contains(name)) {
            early.add(name);
        }
    }
}
