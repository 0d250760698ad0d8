package org.sami.mavlink.link;

import java.util.Objects;

/**
 * A message that came on a link.
 *
 * @param system who sent it
 * @param component which part of the system
 * @param number the sender's sequence number: 0 to 255, then 0 again
 * @param signed whether it was signed, rightly where the link has a key
 * @param payload a message of the library, or {@link #UNREAD}
 */
public record ReceivedMessage(int system, int component, int number, boolean signed, Object payload) {
    /** In place of a message of a kind that nobody reads: what is known of it is that it came. */
    public static final Object UNREAD = new Object();

    /** A message. */
    public ReceivedMessage {
        Objects.requireNonNull(payload, "payload");
    }
}
