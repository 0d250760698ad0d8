package org.sami.spn.protocol;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.model.MarkupSpec;

/**
 * A question to the operator, answered once, by the operator or by autonomy (R-DEC-1).
 *
 * @param mission the mission that asks, or {@link Ids#NONE} where the domain asks ({@link Input.AskOperator})
 * @param activation the activation that asks, or {@link Ids#NONE} for the parameters of a mission that starts, the
 *     choice of an interrupt's proxies and what the engine itself asks
 * @param type the output event type that asks; where the engine itself asks, {@link #INTERRUPT} and the interrupt's name,
 *     {@link #ABORTED} and the place's id, or empty text for the parameters of a mission that starts; where the domain
 *     asks, the kind of its question
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
    /** Prefix of the type of the question which robots a pressed interrupt is for; its name follows. */
    public static final String INTERRUPT = "interrupt:";

    /** Begins the type of the question what becomes of an aborted sub-mission's robots; the id of its place follows. */
    public static final String ABORTED = "aborted:";

    public Decision {
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(prompt, "prompt");
        Objects.requireNonNull(question, "question");
        Objects.requireNonNull(automatic, "automatic");
        Objects.requireNonNull(deadlineMillis, "deadlineMillis");
        Objects.requireNonNull(priority, "priority");
        markups = List.copyOf(markups);
    }

    /** Whether it asks which robots a pressed interrupt is for: {@link Answer.Rejected} withdraws the press then (R-INT-8). */
    public boolean isInterruptChoice() {
        return activation == Ids.NONE && mission != Ids.NONE && type.startsWith(INTERRUPT);
    }

    /** The same decision, which autonomy does not answer at any time. */
    public Decision withoutDeadline() {
        return new Decision(
                id, mission, activation, type, prompt, question, automatic, OptionalLong.empty(), priority, markups);
    }

    /** The same decision with another form of its question, such as one that offers less. */
    public Decision asking(Question other) {
        return new Decision(id, mission, activation, type, prompt, other, automatic, deadlineMillis, priority, markups);
    }
}
