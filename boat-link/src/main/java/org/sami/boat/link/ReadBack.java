package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Asks for the waypoint list as the boat holds it; answered with {@link HeldWaypoints} instead of an {@link Ack}. */
public final class ReadBack extends CommandMessage {
    static final String TYPE = "readback";

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public ReadBack(String commandId) {
        super(commandId);
    }

    static ReadBack read(Fields in) throws LinkException {
        return new ReadBack(in.text("command"));
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {}
}
