package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** A boat's refusal of {@link Hello}, in words; it takes nothing else from this client. */
public final class Goodbye extends LinkMessage {
    static final String TYPE = "goodbye";

    private final String boatId;
    private final String reason;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Goodbye(String boatId, String reason) {
        this.boatId = Checks.id("boat", boatId);
        this.reason = Checks.text("reason", reason);
    }

    static Goodbye read(Fields in) throws LinkException {
        return new Goodbye(in.text("boat"), in.text("reason"));
    }

    /** The boat that answers. */
    public String boatId() {
        return boatId;
    }

    /** Why, for a person. */
    public String reason() {
        return reason;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("boat", boatId);
        out.writeStringField("reason", reason);
    }
}
