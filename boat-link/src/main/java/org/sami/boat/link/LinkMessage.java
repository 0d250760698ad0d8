package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** One message of the boat link. The kinds of message are the classes of this package; nobody else adds one. */
public abstract class LinkMessage {

    LinkMessage() {}

    /** The word that names this kind of message in the body. */
    public abstract String type();

    /** Writes the members of this kind of message into the open JSON object of the body. */
    abstract void write(JsonGenerator out) throws IOException;
}
