package org.sami.lessons.course;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * The course as it was read: what could be read of it. Immutable.
 *
 * @param lessons in the order in which they are taken
 * @param terms the glossary, in the order of its files
 * @param plans the projects that steps and jobs name, by {@code LESSON/FILE} without the ending
 * @param jobs the texts of the job files, by {@code LESSON/JOB}
 */
public record Course(List<Lesson> lessons, List<Term> terms, Map<String, Project> plans, Map<String, String> jobs) {
    public Course {
        lessons = List.copyOf(lessons);
        terms = List.copyOf(terms);
        plans = Collections.unmodifiableMap(new LinkedHashMap<>(plans));
        jobs = Collections.unmodifiableMap(new LinkedHashMap<>(jobs));
    }

    /** The lesson of an id. */
    public Optional<Lesson> lesson(String id) {
        return lessons.stream().filter(lesson -> lesson.id().equals(id)).findFirst();
    }

    /** The lesson that follows another one; empty after the last. */
    public Optional<Lesson> after(String lesson) {
        return neighbour(lesson, 1);
    }

    /** The lesson that comes before another one; empty before the first. */
    public Optional<Lesson> before(String lesson) {
        return neighbour(lesson, -1);
    }

    private Optional<Lesson> neighbour(String lesson, int by) {
        int at = lesson(lesson).map(lessons::indexOf).orElse(-1);
        int next = at + by;
        return at < 0 || next < 0 || next >= lessons.size() ? Optional.empty() : Optional.of(lessons.get(next));
    }

    /**
     * The term of an id, or of words that stand for it.
     *
     * @param words such as {@code places} for {@code place}
     */
    public Optional<Term> term(String words) {
        return terms.stream()
                .filter(term -> term.id().equals(words))
                .findFirst()
                .or(() -> terms.stream().filter(term -> term.names(words)).findFirst());
    }

    /**
     * The project that a lesson's step or job names.
     *
     * @param lesson the id of the lesson
     * @param reference {@code FILE}, {@code LESSON/FILE}, either with {@code #PLAN} at its end
     */
    public Optional<Project> project(String lesson, String reference) {
        return Optional.ofNullable(plans.get(fileOf(lesson, reference)));
    }

    /** The plan that a lesson's step or job names: the one after the {@code #}, else the first of its project. */
    public Optional<Plan> plan(String lesson, String reference) {
        int hash = reference.indexOf('#');
        return project(lesson, reference)
                .flatMap(project ->
                        hash < 0 ? project.plans().stream().findFirst() : project.plan(reference.substring(hash + 1)));
    }

    /** The key of {@link #plans} that a lesson's step or job names, whether it is there or not. */
    public static String fileOf(String lesson, String reference) {
        int hash = reference.indexOf('#');
        String file = hash < 0 ? reference : reference.substring(0, hash);
        return file.contains("/") ? file : lesson + "/" + file;
    }

    /** Where a step is: {@code STEP} of the same lesson, or {@code LESSON/STEP}. */
    public Optional<StepAddress> address(String lesson, String reference) {
        int slash = reference.indexOf('/');
        String of = slash < 0 ? lesson : reference.substring(0, slash);
        String step = slash < 0 ? reference : reference.substring(slash + 1);
        return lesson(of).flatMap(found -> found.step(step)).map(found -> new StepAddress(of, step));
    }

    /** The types of events that were introduced in a lesson and in those before it. */
    public Set<String> eventsKnown(String lesson) {
        return known(lesson, Lesson::events);
    }

    /** The classes of tasks that were introduced in a lesson and in those before it. */
    public Set<String> tasksKnown(String lesson) {
        return known(lesson, Lesson::tasks);
    }

    /** The types of markup that were introduced in a lesson and in those before it. */
    public Set<String> markupsKnown(String lesson) {
        return known(lesson, Lesson::markups);
    }

    private Set<String> known(String lesson, Function<Lesson, List<String>> introduced) {
        Objects.requireNonNull(lesson, "lesson");
        Set<String> known = new LinkedHashSet<>();
        for (Lesson each : lessons) {
            known.addAll(introduced.apply(each));
            if (each.id().equals(lesson)) {
                break;
            }
        }
        return known;
    }

    /** Where a step of the course is. */
    public record StepAddress(String lesson, String step) {
        public StepAddress {
            Objects.requireNonNull(lesson, "lesson");
            Objects.requireNonNull(step, "step");
        }

        @Override
        public String toString() {
            return lesson + "/" + step;
        }
    }

    /** All steps of the course, in order. */
    public List<StepAddress> steps() {
        List<StepAddress> all = new ArrayList<>();
        lessons.forEach(lesson -> lesson.steps().forEach(step -> all.add(new StepAddress(lesson.id(), step.id()))));
        return all;
    }
}
