package org.sami.crw.proxy.link;

import java.net.InetSocketAddress;
import org.sami.spn.protocol.Priority;

/**
 * Something about a link that an operator must know and act on.
 *
 * @param boatId the boat that is concerned; empty if it is not known
 * @param address where it answers
 * @param text the same in words
 * @param priority of the message to the operator, where it becomes one
 */
public record LinkAlarm(Kind kind, String boatId, InetSocketAddress address, String text, Priority priority) {

    /** One of high priority. */
    public LinkAlarm(Kind kind, String boatId, InetSocketAddress address, String text) {
        this(kind, boatId, address, text, Priority.HIGH);
    }

    /** What is wrong. */
    public enum Kind {
        /** Two boats have one id; the one at the address is refused. */
        TWO_BOATS_WITH_ONE_ID,
        /** One boat is reached under two addresses; the second link is refused. */
        ONE_BOAT_AT_TWO_ADDRESSES,
        /** Another boat answers where one was known; it is a boat of its own from now on. */
        ANOTHER_BOAT,
        /** What answers speaks another version of the link; it gets no command. */
        OTHER_VERSION,
        /** The boat speaks the link of before, which is spoken for one release: it obeys bases that were replaced. */
        LINK_OF_BEFORE,
        /** Boats answer at one address under ever new names; further ones are not taken. */
        EVER_NEW_BOATS,
        /** The boat itself, or its gateway, says something; its priority says how much it matters. */
        SAID_BY_BOAT
    }
}
