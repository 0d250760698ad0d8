package org.sami.crw.message;

import java.util.Objects;

/**
 * A message in the operator's list.
 *
 * @param number among all messages of the session, from 1; names it
 * @param acknowledged whether the operator has acknowledged it
 * @param count number of messages with its subject, itself included: it has replaced the others
 * @param muted whether messages with its keyword make no sound and draw no attention
 */
public record MessageEntry(long number, OperatorMessage message, int count, boolean acknowledged, boolean muted) {
    public MessageEntry {
        Objects.requireNonNull(message, "message");
    }
}
