package org.sami.lessons;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.LessonMode;
import org.sami.lessons.course.ReadingTime;
import org.sami.lessons.course.Step;
import org.sami.spn.json.DomainLibrary;

/** The tables of docs/course.md and docs/lesson-modes.md say what the course's files say. */
class CoursePagesTest {
    private static final Path DOCS = Path.of("..", "docs");
    private static final Course COURSE = CourseReader.read(
                    CourseFiles.SHIPPED,
                    DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow())
            .orThrow();

    @Test
    void thePageOfTheModesIsMadeFromTheLessons() throws IOException {
        List<Lesson> lessons =
                COURSE.lessons().stream().filter(lesson -> lesson.number() != 1).toList();
        Set<String> rows = new TreeSet<>();
        lessons.forEach(lesson -> {
            rows.addAll(lesson.mode().hide());
            rows.addAll(lesson.mode().lock());
        });
        StringBuilder table = new StringBuilder("| what |");
        lessons.forEach(lesson -> table.append(' ').append(head(lesson)).append(" |"));
        table.append("\n|---|").append("---|".repeat(lessons.size())).append('\n');
        for (String row : rows) {
            table.append("| `").append(row).append("` |");
            lessons.forEach(
                    lesson -> table.append(' ').append(cell(lesson.mode(), row)).append(" |"));
            table.append('\n');
        }

        hasTable("lesson-modes.md", table.toString());
    }

    private static String head(Lesson lesson) {
        return lesson.number() == 0 ? lesson.title() : "L" + lesson.number();
    }

    private static String cell(LessonMode mode, String row) {
        if (covered(mode.keep(), row)) {
            return "yes";
        }
        return covered(mode.hide(), row) ? "–" : covered(mode.lock(), row) ? "locked" : "yes";
    }

    private static boolean covered(List<String> patterns, String row) {
        return patterns.stream()
                .anyMatch(pattern -> pattern.equals(row)
                        || (pattern.endsWith("*") && row.startsWith(pattern.substring(0, pattern.length() - 1))));
    }

    @Test
    void thePageOfTheCourseSaysWhatIsInEachLessonAndHowLongItTakes() throws IOException {
        StringBuilder table =
                new StringBuilder("| lesson | after it | quizzes | jobs | minutes |\n|---|---|---|---|---|\n");
        for (Lesson lesson : COURSE.lessons()) {
            table.append("| ")
                    .append(lesson.number() == 0 ? "" : lesson.number() + " ")
                    .append(lesson.title())
                    .append(" | ")
                    .append(lesson.summary())
                    .append(" | ")
                    .append(count(List.of(lesson), Step.Quiz.class))
                    .append(" | ")
                    .append(count(List.of(lesson), Step.Job.class))
                    .append(" | ")
                    .append(minutes(List.of(lesson)))
                    .append(" |\n");
        }
        List<Lesson> first = COURSE.lessons().stream()
                .filter(lesson -> (lesson.number() >= 1 && lesson.number() <= 10)
                        || lesson.id().equals("final-panoramas"))
                .toList();
        table.append(row("Lessons 1 to 10 and the two panorama plans", first));
        List<Lesson> withBoth = COURSE.lessons().stream()
                .filter(lesson -> lesson.number() <= 10)
                .toList();
        table.append(row("Lessons 1 to 10 and all final plans", withBoth));
        table.append(row("The whole course", COURSE.lessons()));

        hasTable("course.md", table.toString());
    }

    private static String row(String words, List<Lesson> lessons) {
        return "| **" + words + "** | | " + count(lessons, Step.Quiz.class) + " | " + count(lessons, Step.Job.class)
                + " | " + minutes(lessons) + " |\n";
    }

    private static long count(List<Lesson> lessons, Class<? extends Step> kind) {
        return lessons.stream()
                .flatMap(lesson -> lesson.steps().stream())
                .filter(kind::isInstance)
                .count();
    }

    private static long minutes(List<Lesson> lessons) {
        return Math.round(ReadingTime.of(lessons).toSeconds() / 60.0);
    }

    /** The page has this table; where it has another, the right one is in a file that the failure names. */
    private static void hasTable(String page, String table) throws IOException {
        String found = Files.readAllLines(DOCS.resolve(page)).stream()
                .dropWhile(line -> !line.startsWith("|"))
                .takeWhile(line -> line.startsWith("|"))
                .collect(Collectors.joining("\n", "", "\n"));
        Path right = Path.of("build", page);
        Files.createDirectories(right.getParent());
        Files.writeString(right, table);

        assertThat(found)
                .as("the first table of docs/%s; the right one is in lessons/%s", page, right)
                .isEqualTo(table);
    }
}
