package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * The commander hands the command over to another client and becomes an observer. The boat sends both a {@link Welcome} with their new roles and goes on
 * with what it does.
 */
public final class GrantCommand extends CommandMessage {
    static final String TYPE = "grant-command";

    private final String clientId;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public GrantCommand(String commandId, String clientId) {
        super(commandId);
        this.clientId = Checks.id("client", clientId);
    }

    static GrantCommand read(Fields in) throws LinkException {
        return new GrantCommand(in.text("command"), in.text("client"));
    }

    /** The client that commands from now on, by the name in its hello. */
    public String clientId() {
        return clientId;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeStringField("client", clientId);
    }
}
