package org.sami.crw.operator;

import java.util.Objects;

/**
 * A message as it lies before the operator.
 *
 * @param number of all messages of the session, from 1; names it
 * @param acknowledged whether the operator has said that it is known
 * @param muted whether messages with its keyword are to make no sound and draw no attention
 */
public record MessageEntry(long number, OperatorMessage message, boolean acknowledged, boolean muted) {
    public MessageEntry {
        Objects.requireNonNull(message, "message");
    }
}
