package org.sami.lessons.course;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * A term of the glossary.
 *
 * @param id in kebab case
 * @param term as it is written
 * @param also other words for it, such as the plural
 * @param text what it is, in two sentences
 * @param lesson the id of the lesson that explains it
 * @param step the id of the step that explains it
 */
public record Term(
        @JsonProperty(required = true) String id,
        @JsonProperty(required = true) String term,
        List<String> also,
        @JsonProperty(required = true) String text,
        @JsonProperty(required = true) String lesson,
        @JsonProperty(required = true) String step) {
    public Term {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(term, "term");
        also = Absent.orNone(also);
        Objects.requireNonNull(text, "text");
        Objects.requireNonNull(lesson, "lesson");
        Objects.requireNonNull(step, "step");
    }

    /** Whether words are the term, or stand for it; capitals do not matter. */
    public boolean names(String words) {
        String lower = words.toLowerCase(Locale.ROOT);
        return Stream.concat(Stream.of(term), also.stream())
                .anyMatch(each -> each.toLowerCase(Locale.ROOT).equals(lower));
    }
}
