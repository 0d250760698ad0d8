package org.sami.lessons.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Step;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;

/** Plays everything that the steps of the course show to its end. */
class ShippedShowsTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    @TestFactory
    Stream<DynamicTest> whatAStepShowsCanBePlayedAndGivesItsResult() {
        Course course = CourseReader.read(CourseFiles.SHIPPED, DOMAIN).orThrow();
        return course.lessons().stream()
                .flatMap(lesson -> shows(lesson)
                        .map(show -> DynamicTest.dynamicTest(
                                lesson.id() + "/" + show.id(),
                                () -> assertThat(ShowCheck.check(course, lesson, show, "", DOMAIN))
                                        .extracting(Finding::message)
                                        .isEmpty())));
    }

    private static Stream<Step.Show> shows(Lesson lesson) {
        return lesson.steps().stream().filter(Step.Show.class::isInstance).map(Step.Show.class::cast);
    }
}
