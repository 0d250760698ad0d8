package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Motors to zero; the boat drifts. The waypoint list and its progress stay. */
public final class StopMotors extends CommandMessage {
    static final String TYPE = "stop";

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public StopMotors(String commandId) {
        super(commandId);
    }

    static StopMotors read(Fields in) throws LinkException {
        return new StopMotors(in.text("command"));
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {}
}
