package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;

/** The waypoint list as the boat holds it: the answer to {@link ReadBack}. */
public final class HeldWaypoints extends LinkMessage {
    static final String TYPE = "held";

    private final String commandId;
    private final String listId;
    private final List<Waypoint> waypoints;

    /** Makes the answer to the command with this id. */
    public HeldWaypoints(String commandId, String listId, List<Waypoint> waypoints) {
        this.commandId = Checks.id("command", commandId);
        this.listId = Checks.optionalId("list", listId);
        this.waypoints = WaypointRows.copy(waypoints);
    }

    static HeldWaypoints read(Fields in) throws LinkException {
        return new HeldWaypoints(in.text("command"), in.textOrEmpty("list"), WaypointRows.read(in));
    }

    /** The command that is answered. */
    public String commandId() {
        return commandId;
    }

    /** The list that the boat holds; empty if it holds none. */
    public String listId() {
        return listId;
    }

    /** The waypoints in driving order; unmodifiable. */
    public List<Waypoint> waypoints() {
        return waypoints;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("command", commandId);
        out.writeStringField("list", listId);
        WaypointRows.write(out, waypoints);
    }
}
