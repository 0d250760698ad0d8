package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Drive along the waypoint list that the boat holds, from an index on: to start it, and to continue after a stop. */
public final class StartWaypoints extends CommandMessage {
    static final String TYPE = "start";

    private final String listId;
    private final int index;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public StartWaypoints(String commandId, String listId, int index) {
        super(commandId);
        this.listId = Checks.id("list", listId);
        this.index = Checks.atLeastZero("index", index);
    }

    static StartWaypoints read(Fields in) throws LinkException {
        return new StartWaypoints(in.text("command"), in.text("list"), in.index("index"));
    }

    /** The list; the boat refuses if it holds another. */
    public String listId() {
        return listId;
    }

    /** The waypoint to head for first, counted from 0. */
    public int index() {
        return index;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeStringField("list", listId);
        out.writeNumberField("index", index);
    }
}
