package org.sami.petri.graph;

import java.time.Duration;

/**
 * How far a search may go.
 *
 * @param states how many states may be found, from 1
 * @param bytes how much memory states, hash table and edges may take together, in bytes, from 1
 * @param time how long the search may last, more than zero
 */
public record SearchBudget(int states, long bytes, Duration time) {
    /** The most states that can be numbered. */
    public static final int MOST_STATES = 600_000_000;

    public SearchBudget {
        if (states < 1 || states > MOST_STATES || bytes < 1 || time.isZero() || time.isNegative()) {
            throw new IllegalArgumentException("a search has from 1 to " + MOST_STATES
                    + " states, 1 byte or more and a time above zero, not " + states + ", " + bytes + " and " + time);
        }
    }

    /** A budget that only the number of states limits, and half of the memory that the process may use. */
    public static SearchBudget ofStates(int states) {
        return new SearchBudget(states, Runtime.getRuntime().maxMemory() / 2, Duration.ofDays(365));
    }
}
