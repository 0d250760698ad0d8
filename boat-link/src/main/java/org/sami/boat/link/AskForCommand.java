package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * An observer asks for the command. If no client commands, the boat appoints it. Otherwise the boat passes the request on as {@link CommandAsked}, and the
 * commander may {@link GrantCommand}. The {@link Ack} only confirms that the request has arrived.
 */
public final class AskForCommand extends CommandMessage {
    static final String TYPE = "ask-command";

    private final String session;
    private final long epoch;

    /** A request without a session, as clients of the link of before make it. */
    public AskForCommand(String commandId) {
        this(commandId, "", 0);
    }

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public AskForCommand(String commandId, String session, long epoch) {
        super(commandId);
        this.session = Checks.optionalName("session", session);
        this.epoch = Checks.atLeastZero("epoch", epoch);
    }

    static AskForCommand read(Fields in) throws LinkException {
        return new AskForCommand(in.text("command"), in.textOrEmpty("session"), in.integerOrZero("epoch"));
    }

    /** Id of the client's session; empty for clients of the link of before. */
    public String session() {
        return session;
    }

    /** The number with which the session claims to command, see {@link CommandEpoch}; 0 without a session. */
    public long epoch() {
        return epoch;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        if (!session.isEmpty()) {
            out.writeStringField("session", session);
            out.writeNumberField("epoch", epoch);
        }
    }
}
