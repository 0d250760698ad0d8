package org.sami.dreamm.learn;

import java.util.Objects;
import java.util.Optional;
import org.sami.lessons.job.JobGrader;

/**
 * What a window has to do with the course.
 *
 * @param lesson where the learner is; empty in a window for authors
 * @param grader of the jobs of the course; empty in a window for authors
 * @param access the way into the course and out of it
 */
public record Learning(Optional<LessonModel> lesson, Optional<JobGrader> grader, CourseAccess access) {
    public Learning {
        Objects.requireNonNull(lesson, "lesson");
        Objects.requireNonNull(grader, "grader");
        Objects.requireNonNull(access, "access");
    }
}
