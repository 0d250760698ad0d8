package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * A client commands from now on, whoever did before: for a person who knows why. Both get a {@link Welcome} that says what
 * they are now. The boat goes on with what it does.
 */
public final class TakeCommand extends CommandMessage {
    static final String TYPE = "take-command";

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public TakeCommand(String commandId) {
        super(commandId);
    }

    static TakeCommand read(Fields in) throws LinkException {
        return new TakeCommand(in.text("command"));
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {}
}
