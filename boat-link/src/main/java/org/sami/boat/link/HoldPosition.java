package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Keep station where the boat is now. The waypoint list and its progress stay. */
public final class HoldPosition extends CommandMessage {
    static final String TYPE = "hold";

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public HoldPosition(String commandId) {
        super(commandId);
    }

    static HoldPosition read(Fields in) throws LinkException {
        return new HoldPosition(in.text("command"));
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {}
}
