package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** The boat has taken and executed the command. */
public final class Ack extends LinkMessage {
    static final String TYPE = "ack";

    private final String commandId;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Ack(String commandId) {
        this.commandId = Checks.id("command", commandId);
    }

    static Ack read(Fields in) throws LinkException {
        return new Ack(in.text("command"));
    }

    /** The command that is answered. */
    public String commandId() {
        return commandId;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("command", commandId);
    }
}
