package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/**
 * A marking from which a mission is to start instead of its start place, to try a plan from the middle
 * ({@code Engine.startAt}).
 *
 * @param places in the order in which they are entered; each once
 */
public record StartMarking(List<Tokens> places) {
    public StartMarking {
        places = List.copyOf(places);
    }

    /**
     * What enters one place, as one visit: so many generic tokens, then one token a robot, then one a task. Without any the place is
     * entered by nobody.
     *
     * @param place id of a place that is no end place
     * @param tasks names of the plan's tasks
     */
    public record Tokens(String place, int generic, List<String> proxies, List<String> tasks) {
        public Tokens {
            Objects.requireNonNull(place, "place");
            if (generic < 0) {
                throw new IllegalArgumentException("A number of tokens is not negative: " + generic);
            }
            proxies = List.copyOf(proxies);
            tasks = List.copyOf(tasks);
        }
    }
}
