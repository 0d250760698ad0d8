package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Ends the latched fleet stop. It starts nothing: the boat stays stopped until its next command. */
public final class FleetRelease extends CommandMessage {
    static final String TYPE = "fleet-release";

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public FleetRelease(String commandId) {
        super(commandId);
    }

    static FleetRelease read(Fields in) throws LinkException {
        return new FleetRelease(in.text("command"));
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {}
}
