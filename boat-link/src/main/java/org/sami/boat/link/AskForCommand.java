package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * An observer asks for the command. If no client commands, the boat appoints it. Otherwise the boat passes the request on as {@link CommandAsked}, and the
 * commander may {@link GrantCommand}. The {@link Ack} only confirms that the request has arrived.
 */
public final class AskForCommand extends CommandMessage {
    static final String TYPE = "ask-command";

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public AskForCommand(String commandId) {
        super(commandId);
    }

    static AskForCommand read(Fields in) throws LinkException {
        return new AskForCommand(in.text("command"));
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {}
}
