package org.sami.crw.operator;

import java.util.List;
import java.util.Objects;
import org.sami.spn.protocol.Priority;

/**
 * Something that the operator is told and need not answer (appendix .2.1, Display Message; thesis 6.3.4).
 *
 * @param atMillis when, on the session's clock
 * @param mission whose message it is, or {@code Ids.NONE}
 * @param text one or a few sentences
 * @param boats whom it is about, for zooming and highlighting; may be empty
 * @param keyword a later message with the same keyword replaces this one; empty text = none does
 */
public record OperatorMessage(
        long atMillis,
        long mission,
        Source source,
        Priority priority,
        String text,
        List<String> boats,
        String keyword) {
    /** Who speaks. */
    public enum Source {
        /** A plan, by an output event. */
        PLAN,
        /** The engine: something that it noted. */
        ENGINE,
        /** A handler or a boat's proxy. */
        DOMAIN
    }

    public OperatorMessage {
        Objects.requireNonNull(source, "source");
        Objects.requireNonNull(priority, "priority");
        Objects.requireNonNull(text, "text");
        boats = List.copyOf(boats);
        Objects.requireNonNull(keyword, "keyword");
    }
}
