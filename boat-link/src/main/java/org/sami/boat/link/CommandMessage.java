package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * A message that asks something of the boat and is answered by {@link Ack} or {@link Nack} with the same command id.
 *
 * <p>The id is what makes it safe to send again: a boat answers a repeated id with its first answer and does not execute
 * it a second time.
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

    /** Writes what this kind of command has beside its id. */
    abstract void writeCommand(JsonGenerator out) throws IOException;
}
