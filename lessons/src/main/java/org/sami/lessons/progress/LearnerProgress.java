package org.sami.lessons.progress;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.time.LocalDate;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.Lesson;

/**
 * What a learner has done of the course, and where he is. Immutable; each change gives another one.
 *
 * @param learner the name
 * @param at the step at which he is, as {@code LESSON/STEP}; empty where he has not begun
 * @param steps what he has done on each step, by {@code LESSON/STEP}
 * @param begun the day on which he began a lesson, as ISO 8601 has it, by the lesson's id
 */
public record LearnerProgress(
        @JsonProperty(required = true) int formatVersion,
        @JsonProperty(required = true) String learner,
        @JsonProperty(required = true) Optional<String> at,
        @JsonProperty(required = true) Map<String, StepProgress> steps,
        Map<String, String> begun) {
    /** The version of the format that this program reads. */
    public static final int FORMAT_VERSION = 1;

    public LearnerProgress {
        if (formatVersion != FORMAT_VERSION) {
            throw new IllegalArgumentException(
                    "\"formatVersion\" is " + formatVersion + "; this program reads " + FORMAT_VERSION);
        }
        Objects.requireNonNull(learner, "learner");
        Objects.requireNonNull(at, "at");
        steps = Collections.unmodifiableMap(new LinkedHashMap<>(steps));
        begun = orNone(begun);
    }

    private static Map<String, String> orNone(@Nullable Map<String, String> days) {
        return days == null ? Map.of() : Collections.unmodifiableMap(new LinkedHashMap<>(days));
    }

    /** Somebody who has not begun. */
    public static LearnerProgress of(String learner) {
        return new LearnerProgress(FORMAT_VERSION, learner, Optional.empty(), Map.of(), Map.of());
    }

    /** Where he goes on in a course: the step at which he was, if the course still has it, else the first step. */
    public Optional<StepAddress> resume(Course course) {
        return at.flatMap(address -> course.address("", address))
                .or(() -> course.steps().stream().findFirst());
    }

    /** What he has done on a step. */
    public StepProgress on(StepAddress step) {
        return steps.getOrDefault(step.toString(), StepProgress.NONE);
    }

    /** How many steps of a lesson are done. */
    public int done(Lesson lesson) {
        return (int) lesson.steps().stream()
                .filter(step -> on(new StepAddress(lesson.id(), step.id())).done())
                .count();
    }

    /** Whether all steps of a lesson are done. */
    public boolean isDone(Lesson lesson) {
        return done(lesson) == lesson.steps().size();
    }

    /** He is at a step now. */
    public LearnerProgress movedTo(StepAddress step) {
        return new LearnerProgress(formatVersion, learner, Optional.of(step.toString()), steps, begun);
    }

    /** He has begun a lesson on a day, unless he had begun it before. */
    public LearnerProgress begun(String lesson, LocalDate day) {
        if (begun.containsKey(lesson)) {
            return this;
        }
        Map<String, String> days = new LinkedHashMap<>(begun);
        days.put(lesson, day.toString());
        return new LearnerProgress(formatVersion, learner, at, steps, days);
    }

    /** The day on which he began a lesson; empty where he has not, or nobody kept it. */
    public Optional<LocalDate> begun(String lesson) {
        return Optional.ofNullable(begun.get(lesson)).map(LocalDate::parse);
    }

    /** He has read, seen or played a step. */
    public LearnerProgress read(StepAddress step) {
        return with(step, StepProgress::read);
    }

    /** He has answered a quiz, or had a job checked. */
    public LearnerProgress attempted(StepAddress step, boolean right) {
        return with(step, progress -> progress.attempted(right));
    }

    /** He was shown one more hint. */
    public LearnerProgress hinted(StepAddress step) {
        return with(step, StepProgress::hinted);
    }

    /** He was shown the solution. */
    public LearnerProgress solved(StepAddress step) {
        return with(step, StepProgress::solved);
    }

    /** He has spent time on a step, in milliseconds. */
    public LearnerProgress spent(StepAddress step, long millis) {
        return millis <= 0 ? this : with(step, progress -> progress.spent(millis));
    }

    private LearnerProgress with(StepAddress step, UnaryOperator<StepProgress> change) {
        Map<String, StepProgress> next = new LinkedHashMap<>(steps);
        next.put(step.toString(), change.apply(on(step)));
        return new LearnerProgress(formatVersion, learner, at, next, begun);
    }
}
