package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** The boat has refused the command and nothing has changed. */
public final class Nack extends LinkMessage {
    static final String TYPE = "nack";

    private final String commandId;
    private final NackReason reason;
    private final String detail;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Nack(String commandId, NackReason reason, String detail) {
        this.commandId = Checks.optionalId("command", commandId);
        this.reason = Objects.requireNonNull(reason, "reason");
        this.detail = Checks.text("detail", detail);
    }

    static Nack read(Fields in) throws LinkException {
        return new Nack(in.textOrEmpty("command"), in.word("reason", NackReason.class), in.text("detail"));
    }

    /** The command that is answered; empty if it could not be read. */
    public String commandId() {
        return commandId;
    }

    /** Why it was refused. */
    public NackReason reason() {
        return reason;
    }

    /** The same for a person. */
    public String detail() {
        return detail;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("command", commandId);
        out.writeStringField("reason", reason.name());
        out.writeStringField("detail", detail);
    }
}
