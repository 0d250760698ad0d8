package org.sami.crw.report;

import java.util.Objects;

/**
 * One firing of a transition.
 *
 * @param number of the firing in the session, from 1
 * @param input index of the journal entry that caused it
 * @param atMillis simulated time
 * @param transition name of the transition, or its id where it has none
 * @param events the input events that it used up, in words
 * @param moves what happened to tokens, in words
 */
public record FiringResult(
        long number,
        long input,
        long atMillis,
        long mission,
        String plan,
        String transition,
        String events,
        String moves) {
    public FiringResult {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(transition, "transition");
        Objects.requireNonNull(events, "events");
        Objects.requireNonNull(moves, "moves");
    }
}
