package org.sami.lessons.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Lesson;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;

class JobUseCheckTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final CourseFiles FILES = CourseFiles.onClassPath("org/sami/lessons/course-of-jobs");
    private static final Course COURSE = CourseReader.read(FILES, DOMAIN).orThrow();

    private static List<Finding> check(List<String> events) {
        Lesson all = COURSE.lessons().get(0);
        Lesson lesson = new Lesson(
                all.formatVersion(),
                all.id(),
                all.number(),
                all.title(),
                all.summary(),
                events,
                all.tasks(),
                all.markups(),
                all.terms(),
                all.mode(),
                all.steps());
        Course course = new Course(List.of(lesson), COURSE.terms(), COURSE.plans(), COURSE.jobs());
        return JobUseCheck.check(course, lesson, "gather", DOMAIN);
    }

    @Test
    void aJobThatUsesWhatIsIntroducedIsRight() {
        assertThat(check(COURSE.lessons().get(0).events())).isEmpty();
    }

    @Test
    void aSolutionWithAnEventThatNoLessonHasIntroducedIsNamed() {
        List<String> events = new ArrayList<>(COURSE.lessons().get(0).events());
        events.remove("ProxyPathCompleted");

        assertThat(check(events))
                .anyMatch(f -> f.pointer().equals("/solution")
                        && f.message().contains("the solution uses ProxyPathCompleted"));
    }
}
