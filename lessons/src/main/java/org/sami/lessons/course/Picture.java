package org.sami.lessons.course;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Objects;

/**
 * A picture that is drawn from a plan.
 *
 * @param plan which: {@link Course#plan}
 * @param mark ids of elements that are pointed out
 * @param tokens what stands in places
 * @param caption a sentence below it; empty text where it has none
 */
public record Picture(
        @JsonProperty(required = true) String plan, List<String> mark, List<TokensAt> tokens, String caption) {
    public Picture {
        Objects.requireNonNull(plan, "plan");
        mark = Absent.orNone(mark);
        tokens = Absent.orNone(tokens);
        caption = Absent.orEmpty(caption);
    }
}
