package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Motors to zero, latched: every motion is refused until {@link FleetRelease}. */
public final class FleetStop extends CommandMessage {
    static final String TYPE = "fleet-stop";

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public FleetStop(String commandId) {
        super(commandId);
    }

    static FleetStop read(Fields in) throws LinkException {
        return new FleetStop(in.text("command"));
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {}
}
