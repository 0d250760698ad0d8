package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** To the commander: another client asks for the command; {@link GrantCommand} grants it. */
public final class CommandAsked extends LinkMessage {
    static final String TYPE = "command-asked";

    private final String clientId;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public CommandAsked(String clientId) {
        this.clientId = Checks.id("client", clientId);
    }

    static CommandAsked read(Fields in) throws LinkException {
        return new CommandAsked(in.text("client"));
    }

    /** The client that asks, by the name in its hello. */
    public String clientId() {
        return clientId;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("client", clientId);
    }
}
