package org.sami.lessons.course;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A lesson: what it introduces, what of the window it leaves, and its steps.
 *
 * @param formatVersion of its file
 * @param id the name of its folder
 * @param number 1 to 13; 0 for a final plan
 * @param summary what one can do after it, in a sentence
 * @param events the types of events that it introduces
 * @param tasks the classes of tasks that it introduces
 * @param markups the types of markup that it introduces
 * @param terms the ids of the terms that it explains
 * @param mode what the window hides and locks while it is taken
 */
public record Lesson(
        @JsonProperty(required = true) int formatVersion,
        @JsonProperty(required = true) String id,
        @JsonProperty(required = true) int number,
        @JsonProperty(required = true) String title,
        @JsonProperty(required = true) String summary,
        List<String> events,
        List<String> tasks,
        List<String> markups,
        List<String> terms,
        @JsonProperty(required = true) LessonMode mode,
        @JsonProperty(required = true) List<Step> steps) {
    /** The version of the format that this program reads. */
    public static final int FORMAT_VERSION = 1;

    public Lesson {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(summary, "summary");
        events = Absent.orNone(events);
        tasks = Absent.orNone(tasks);
        markups = Absent.orNone(markups);
        terms = Absent.orNone(terms);
        Objects.requireNonNull(mode, "mode");
        steps = List.copyOf(steps);
    }

    /** The step of an id. */
    public Optional<Step> step(String stepId) {
        return steps.stream().filter(step -> step.id().equals(stepId)).findFirst();
    }

    /** What people call it: "Lesson 2: Places and transitions", or its title alone where it has no number. */
    public String heading() {
        return number == 0 ? title : "Lesson " + number + ": " + title;
    }
}
