package org.sami.spn.engine;

import java.util.Objects;
import org.sami.spn.protocol.Occurrence;

/**
 * An occurrence that a transition has received and keeps, as it cannot fire yet.
 *
 * @param transition id of the transition
 * @param input id of its input event
 */
public record PendingAnswer(String transition, String input, Occurrence occurrence) {
    public PendingAnswer {
        Objects.requireNonNull(transition, "transition");
        Objects.requireNonNull(input, "input");
        Objects.requireNonNull(occurrence, "occurrence");
    }
}
