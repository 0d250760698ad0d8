package org.sami.crw.report;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * A question to the operator.
 *
 * @param type the event that asked, or empty text where the engine itself did
 * @param openedAtMillis simulated time at which it was asked
 * @param closedAtMillis simulated time at which it was answered or became idle; empty = still open
 * @param by {@code operator}, {@code autonomy}, or empty text where nobody answered
 * @param answer in words
 * @param clicks what answering cost the operator
 */
public record DecisionResult(
        long id,
        long mission,
        String type,
        String prompt,
        long openedAtMillis,
        OptionalLong closedAtMillis,
        String by,
        String answer,
        int clicks) {
    public DecisionResult {
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(prompt, "prompt");
        Objects.requireNonNull(closedAtMillis, "closedAtMillis");
        Objects.requireNonNull(by, "by");
        Objects.requireNonNull(answer, "answer");
    }

    /** Whether somebody answered it. */
    public boolean answered() {
        return !by.isEmpty();
    }
}
