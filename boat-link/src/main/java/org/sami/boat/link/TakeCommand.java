package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * A client takes the command, whoever had it before: for a person who knows why. The boat sends both a {@link Welcome} with their new roles and goes on
 * with what it does.
 */
public final class TakeCommand extends CommandMessage {
    static final String TYPE = "take-command";

    private final String session;
    private final long epoch;

    /** A request without a session, as clients of the link of before make it. */
    public TakeCommand(String commandId) {
        this(commandId, "", 0);
    }

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public TakeCommand(String commandId, String session, long epoch) {
        super(commandId);
        this.session = Checks.optionalName("session", session);
        this.epoch = Checks.atLeastZero("epoch", epoch);
    }

    static TakeCommand read(Fields in) throws LinkException {
        return new TakeCommand(in.text("command"), in.textOrEmpty("session"), in.integerOrZero("epoch"));
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
