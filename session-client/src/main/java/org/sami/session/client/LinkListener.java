package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;

/** Follows a {@link SessionLink}; called on its thread. */
interface LinkListener {
    /** Logged in, for the first time or again; the server's {@code welcome}. */
    void welcomed(JsonNode message);

    /** A message that answers no request. */
    void received(JsonNode message);

    /** The connection is lost, or could not be made, and is tried again. */
    void lost(String why);

    /** The server does not let this person in, or no longer: nothing is tried any more. */
    void ended(String why);
}
