package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Says that the sender is alive; sent at least once a second where nothing else is. */
public final class Heartbeat extends LinkMessage {
    static final String TYPE = "heartbeat";

    private final long timeMs;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Heartbeat(long timeMs) {
        this.timeMs = Checks.atLeastZero("time", timeMs);
    }

    static Heartbeat read(Fields in) throws LinkException {
        return new Heartbeat(in.integer("time"));
    }

    /** The sender's own clock in milliseconds, of no meaning to the receiver but for display. */
    public long timeMs() {
        return timeMs;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeNumberField("time", timeMs);
    }
}
