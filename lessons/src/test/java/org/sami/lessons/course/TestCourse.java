package org.sami.lessons.course;

import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;

/** The small course of the tests, and the domain of the boats. */
final class TestCourse {
    static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    static final CourseFiles FILES = CourseFiles.onClassPath("org/sami/lessons/course-of-tests");

    private TestCourse() {}

    static Course read() {
        Reading<Course> read = CourseReader.read(FILES, DOMAIN);
        if (read.hasErrors()) {
            throw new AssertionError(read.findings());
        }
        return read.orThrow();
    }

    static Step.Quiz quiz(Course course, String lesson, String step) {
        return (Step.Quiz) course.lesson(lesson).orElseThrow().step(step).orElseThrow();
    }
}
