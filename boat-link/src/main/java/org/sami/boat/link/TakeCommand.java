package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * A client takes the command, whoever had it before: for a person who knows why. The boat sends both a {@link Welcome} with their new roles and goes on
 * with what it does.
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
