package org.sami.lessons.course;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;

/**
 * The file {@code course.json}: of what a course consists.
 *
 * @param lessons folders, in the order of the lessons
 * @param terms files of the glossary
 */
record CourseIndex(
        @JsonProperty(required = true) int formatVersion,
        @JsonProperty(required = true) List<String> lessons,
        @JsonProperty(required = true) List<String> terms) {
    static final String FILE = "course.json";

    CourseIndex {
        lessons = List.copyOf(lessons);
        terms = List.copyOf(terms);
    }
}
