package org.sami.lessons.course;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Objects;

/**
 * The tokens that stand in a place.
 *
 * @param place its id
 * @param generic how many generic tokens
 * @param robots the robots whose tokens stand there, by name
 * @param tasks the tasks whose tokens stand there, by name
 */
public record TokensAt(
        @JsonProperty(required = true) String place, int generic, List<String> robots, List<String> tasks) {
    public TokensAt {
        Objects.requireNonNull(place, "place");
        robots = Absent.orNone(robots);
        tasks = Absent.orNone(tasks);
        if (generic < 0) {
            throw new IllegalArgumentException("\"generic\" is not negative: " + generic);
        }
    }

    /** Whether no token stands there. */
    public boolean isEmpty() {
        return generic == 0 && robots.isEmpty() && tasks.isEmpty();
    }

    /** The same tokens, in an order that does not matter. */
    TokensAt sorted() {
        return new TokensAt(
                place,
                generic,
                robots.stream().sorted().toList(),
                tasks.stream().sorted().toList());
    }
}
