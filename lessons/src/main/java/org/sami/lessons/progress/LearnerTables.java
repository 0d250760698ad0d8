package org.sami.lessons.progress;

import java.time.LocalDate;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Step;

/**
 * What learners have done, in the layout of the thesis's tables 9.1 to 9.4 with one more for hints: a line a learner, a column a lesson. Tables are lists of lines of
 * cells, the first line the heads.
 */
public final class LearnerTables {
    private final Course course;
    private final List<LearnerProgress> learners;

    /** The tables of some learners of a course. */
    public LearnerTables(Course course, List<LearnerProgress> learners) {
        this.course = Objects.requireNonNull(course, "course");
        this.learners = List.copyOf(learners);
    }

    /**
     * A table.
     *
     * @param title such as {@code Time}
     * @param lines the heads, then a line a learner
     */
    public record Table(String title, List<List<String>> lines) {
        public Table {
            Objects.requireNonNull(title, "title");
            lines = lines.stream().map(List::copyOf).toList();
        }

        /** As comma-separated values (RFC 4180), with the title in the first column of the heads. */
        public String csv() {
            StringBuilder all = new StringBuilder();
            for (List<String> line : lines) {
                all.append(String.join(",", line.stream().map(Table::cell).toList()))
                        .append("\r\n");
            }
            return all.toString();
        }

        private static String cell(String text) {
            boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\r' || c == '\n');
            return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
        }
    }

    /** All tables, in order. */
    public List<Table> all() {
        return List.of(times(), days(), quizzes(), jobs(), hints());
    }

    /** How long each lesson took, as hours, minutes and seconds, and all of them (Table 9.1). */
    public Table times() {
        return table(
                "Time",
                learner -> lesson -> time(millis(learner, lesson)),
                learner -> time(course.lessons().stream()
                        .mapToLong(lesson -> millis(learner, lesson))
                        .sum()));
    }

    /** How many days after the lesson before it each lesson was begun (Table 9.2). */
    public Table days() {
        return table("Days since the lesson before", learner -> lesson -> days(learner, lesson), learner -> "");
    }

    /** How many quizzes of each lesson were right at once, of how many (Table 9.3). */
    public Table quizzes() {
        return counted(
                "Quizzes right at once",
                Step.Quiz.class,
                learner -> address -> learner.on(address).rightAtOnce());
    }

    /** How many jobs of each lesson were passed without the solution, of how many (Table 9.4). */
    public Table jobs() {
        return counted(
                "Jobs passed",
                Step.Job.class,
                learner -> address ->
                        learner.on(address).done() && !learner.on(address).solutionSeen());
    }

    /** How many hints were used in each lesson, and how often its jobs were checked. */
    public Table hints() {
        return table(
                "Hints (checks)",
                learner -> lesson -> {
                    int hints = jobsOf(lesson)
                            .mapToInt(step -> learner.on(step).hints())
                            .sum();
                    int checks = jobsOf(lesson)
                            .mapToInt(step -> learner.on(step).attempts())
                            .sum();
                    return checks == 0 && hints == 0 ? "-" : hints + " (" + checks + ")";
                },
                learner -> "");
    }

    private static Stream<StepAddress> jobsOf(Lesson lesson) {
        return lesson.steps().stream()
                .filter(Step.Job.class::isInstance)
                .map(step -> new StepAddress(lesson.id(), step.id()));
    }

    private Table counted(
            String title, Class<? extends Step> kind, Function<LearnerProgress, Function<StepAddress, Boolean>> right) {
        return table(
                title,
                learner -> lesson -> {
                    List<StepAddress> steps = lesson.steps().stream()
                            .filter(kind::isInstance)
                            .map(step -> new StepAddress(lesson.id(), step.id()))
                            .toList();
                    boolean tried =
                            steps.stream().anyMatch(step -> learner.on(step).attempts() > 0);
                    long good = steps.stream()
                            .filter(step -> right.apply(learner).apply(step))
                            .count();
                    return tried ? good + "/" + steps.size() : "-";
                },
                learner -> "");
    }

    private Table table(
            String title,
            Function<LearnerProgress, Function<Lesson, String>> cell,
            Function<LearnerProgress, String> total) {
        List<List<String>> lines = new ArrayList<>();
        List<String> heads = new ArrayList<>(List.of(title));
        course.lessons().forEach(lesson -> heads.add(lesson.number() == 0 ? lesson.title() : "L" + lesson.number()));
        boolean hasTotal = learners.stream().map(total).anyMatch(text -> !text.isEmpty());
        if (hasTotal) {
            heads.add("Total");
        }
        lines.add(heads);
        for (LearnerProgress learner : learners) {
            List<String> line = new ArrayList<>(List.of(learner.learner()));
            course.lessons().forEach(lesson -> line.add(cell.apply(learner).apply(lesson)));
            if (hasTotal) {
                line.add(total.apply(learner));
            }
            lines.add(line);
        }
        return new Table(title, lines);
    }

    private static long millis(LearnerProgress learner, Lesson lesson) {
        return lesson.steps().stream()
                .mapToLong(step ->
                        learner.on(new StepAddress(lesson.id(), step.id())).millis())
                .sum();
    }

    private static String time(long millis) {
        long seconds = millis / 1000;
        return seconds == 0
                ? "-"
                : seconds >= 3600
                        ? String.format("%d:%02d:%02d", seconds / 3600, seconds / 60 % 60, seconds % 60)
                        : String.format("%d:%02d", seconds / 60, seconds % 60);
    }

    private String days(LearnerProgress learner, Lesson lesson) {
        Optional<LocalDate> day = learner.begun(lesson.id());
        Optional<LocalDate> before = course.before(lesson.id()).flatMap(other -> learner.begun(other.id()));
        return day.isPresent() && before.isPresent()
                ? String.valueOf(ChronoUnit.DAYS.between(before.get(), day.get()))
                : "-";
    }
}
