package org.sami.crw.sim.run;

import java.util.List;
import java.util.Objects;

/**
 * Where a mission stands and what it waits for there.
 *
 * @param missions how many stand there alike; sub-missions of one plan may be many
 * @param plan id of the mission's plan
 * @param place name of the place, or its id where it has none
 * @param tokens who is there, in words, copies counted; empty where the place was entered by nobody
 * @param occurrence what lets it go on, in words: input events with {@code or} between them, or why no transition fires
 */
public record Wait(int missions, String plan, String place, List<String> tokens, String occurrence) {
    public Wait {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(place, "place");
        tokens = List.copyOf(tokens);
        Objects.requireNonNull(occurrence, "occurrence");
    }
}
