package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;

/** Follows a {@link SessionLink}; called on its thread. */
interface LinkListener {
    /** Logged in, for the first time or again; the server's {@code welcome}. */
    void welcomed(JsonNode message);

    /** A message that answers no request. */
    void received(JsonNode message);

    /**
     * The connection is lost.
     *
     * @param trying where it is tried again, as the end of a sentence
     */
    void lost(String why, String trying);

    /** A base has answered that does not serve the session, and others are tried; in a sentence. */
    void waits(String words);

    /** Nothing has come for 1.5 s from a server that sends something twice a second; or something has come again. The connection stands. */
    void quiet(boolean now);

    /** No server lets this person in, or no longer, or none answered the first connection: nothing is tried any more. */
    void ended(String why);
}
