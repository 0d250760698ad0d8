package org.sami.lessons.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.LocalDate;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.json.DomainLibrary;

class LearnerTablesTest {
    private final Course course = CourseReader.read(
                    CourseFiles.onClassPath("org/sami/lessons/course-of-tests"),
                    DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow())
            .orThrow();

    private final LearnerProgress ada = LearnerProgress.of("Ada, the first")
            .begun("01-one", LocalDate.of(2026, 11, 20))
            .begun("02-two", LocalDate.of(2026, 11, 22))
            .attempted(new StepAddress("01-one", "which"), true)
            .attempted(new StepAddress("01-one", "mark"), false)
            .attempted(new StepAddress("01-one", "mark"), true)
            .spent(new StepAddress("01-one", "which"), 83_400)
            .spent(new StepAddress("02-two", "where"), 3_600_000);

    private final LearnerTables tables = new LearnerTables(course, List.of(ada, LearnerProgress.of("Ben")));

    @Test
    void timesHaveALineALearnerAColumnALessonAndATotal() {
        assertThat(tables.times().lines())
                .containsExactly(
                        List.of("Time", "L1", "L2", "Total"),
                        List.of("Ada, the first", "1:23", "1:00:00", "1:01:23"),
                        List.of("Ben", "-", "-", "-"));
    }

    @Test
    void daysCountFromTheLessonBefore() {
        assertThat(tables.days().lines().get(1)).containsExactly("Ada, the first", "-", "2");
    }

    @Test
    void ofQuizzesThoseCountThatWereRightAtOnce() {
        assertThat(tables.quizzes().lines().get(1)).containsExactly("Ada, the first", "1/2", "-");
    }

    @Test
    void cellsWithCommasAreQuoted() {
        assertThat(tables.days().csv())
                .isEqualTo("Days since the lesson before,L1,L2\r\n\"Ada, the first\",-,2\r\nBen,-,-\r\n");
    }

    @Test
    void aLessonIsBegunOnce() {
        assertThat(ada.begun("01-one", LocalDate.of(2027, 1, 1)).begun("01-one"))
                .contains(LocalDate.of(2026, 11, 20));
    }
}
