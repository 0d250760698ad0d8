package org.sami.spn.protocol;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.model.MarkupSpec;

/**
 * A question to the operator, answered once, by the operator or by autonomy (DESIGN, How data flows).
 *
 * @param activation the activation that asks, or {@link Ids#NONE} for the parameters of a mission that starts, the
 *     choice of an interrupt's proxies and what the engine itself asks
 * @param type the output event type that asks; empty text where the engine itself asks
 * @param prompt one sentence for the operator
 * @param automatic what autonomy would answer; empty where it has no sensible answer
 * @param deadlineMillis when autonomy answers, on the session's clock; empty = never
 */
public record Decision(
        long id,
        long mission,
        long activation,
        String type,
        String prompt,
        Question question,
        Optional<Answer> automatic,
        OptionalLong deadlineMillis,
        Priority priority,
        List<MarkupSpec> markups) {
    public Decision {
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(prompt, "prompt");
        Objects.requireNonNull(question, "question");
        Objects.requireNonNull(automatic, "automatic");
        Objects.requireNonNull(deadlineMillis, "deadlineMillis");
        Objects.requireNonNull(priority, "priority");
        markups = List.copyOf(markups);
    }
}
