package org.sami.crw.operator.message;

import java.util.Objects;

/**
 * A message as it lies before the operator.
 *
 * @param number of all messages of the session, from 1; names it
 * @param acknowledged whether the operator has said that it is known
 * @param count how many messages with its subject there were, itself included: it has replaced the others
 * @param muted whether messages with its keyword are to make no sound and draw no attention
 */
public record MessageEntry(long number, OperatorMessage message, int count, boolean acknowledged, boolean muted) {
    public MessageEntry {
        Objects.requireNonNull(message, "message");
    }
}
