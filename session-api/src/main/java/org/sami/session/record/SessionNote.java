package org.sami.session.record;

import java.util.Locale;
import java.util.Objects;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.protocol.Ids;

/**
 * A message to the operator, as a session records it.
 *
 * @param kind kind of message: {@code plan message}, {@code domain message}, {@link #LINK}, {@link #JOURNAL}
 * @param mission the mission concerned; {@link Ids#NONE} for none
 */
public record SessionNote(long atMillis, String kind, long mission, String text) {
    /** Kind of a note about a link. */
    public static final String LINK = "link";

    /** Kind of a note about the journal. */
    public static final String JOURNAL = "journal";

    private static final String MESSAGE = " message";

    public SessionNote {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(text, "text");
    }

    /** What the session notes of a message to the operator. */
    public static SessionNote of(OperatorMessage message) {
        String source = message.source().name().toLowerCase(Locale.ROOT);
        return new SessionNote(message.atMillis(), source + MESSAGE, message.mission(), message.text());
    }

    /** Whether it was a message to the operator. */
    public boolean isMessage() {
        return kind.endsWith(MESSAGE);
    }

    /** Who spoke, in a message. */
    String source() {
        return kind.substring(0, kind.length() - MESSAGE.length()).toUpperCase(Locale.ROOT);
    }

    /** Whether it is the domain that speaks of a boat, or of a link: what the operator is to see at once. */
    public boolean isUrgent() {
        return kind.equals(LINK) || kind.equals("domain message");
    }
}
