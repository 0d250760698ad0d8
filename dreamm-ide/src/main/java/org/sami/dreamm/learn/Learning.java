package org.sami.dreamm.learn;

import java.util.Objects;
import java.util.Optional;

/**
 * What a window has to do with the course.
 *
 * @param lesson where the learner is; empty in a window for authors
 * @param door the way into the course and out of it
 */
public record Learning(Optional<LessonModel> lesson, CourseDoor door) {
    public Learning {
        Objects.requireNonNull(lesson, "lesson");
        Objects.requireNonNull(door, "door");
    }
}
