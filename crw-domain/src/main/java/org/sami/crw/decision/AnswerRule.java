package org.sami.crw.decision;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * One rule of an answers file: which decision it answers, and how (docs/answers-file.md).
 *
 * @param pointer where it stands in the file
 * @param event name of the output event type that asks, or the type of what the engine asks ({@code Decision#type}); for a
 *     start rule, the field or variable that is asked for
 * @param start whether it gives a value that is asked for when a mission starts
 * @param plan the plan that asks; empty = any
 * @param nth the how-many-th such decision of the run, from 1; empty = each
 * @param answer the answer's form and content
 */
record AnswerRule(
        String pointer, String event, boolean start, Optional<String> plan, OptionalInt nth, JsonNode answer) {
    /** Begins the event of a rule for what is asked at the start. */
    static final String START = "start:";

    AnswerRule {
        Objects.requireNonNull(pointer, "pointer");
        Objects.requireNonNull(event, "event");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(nth, "nth");
        Objects.requireNonNull(answer, "answer");
    }

    boolean fitsPlan(String asking) {
        return plan.isEmpty() || plan.get().equals(asking);
    }

    /** Whether an asked item is meant: by its whole key or by the field's name after the event's id. */
    boolean fitsItem(String key) {
        return key.equals(event) || key.endsWith("." + event);
    }
}
