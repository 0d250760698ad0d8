package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * A command to the boat; {@link Ack} or {@link Nack} with the same command id answers it.
 *
 * <p>The id makes it safe to send a command again: the boat answers a repeated id with its first answer and does not execute it a second time.
 */
public abstract class CommandMessage extends LinkMessage {
    private final String commandId;

    CommandMessage(String commandId) {
        this.commandId = Checks.id("command", commandId);
    }

    /** The id of this command, unique among all that the boat ever gets. */
    public final String commandId() {
        return commandId;
    }

    @Override
    final void write(JsonGenerator out) throws IOException {
        out.writeStringField("command", commandId);
        writeCommand(out);
    }

    /** Writes the members of this kind of command, without its id. */
    abstract void writeCommand(JsonGenerator out) throws IOException;
}
