package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;

/**
 * A whole waypoint list for the boat. It replaces the list that the boat holds, whole or not at all, and starts nothing: a
 * boat that was on its old list keeps station until the new one is started.
 */
public final class UploadWaypoints extends CommandMessage {
    static final String TYPE = "upload";

    private final String listId;
    private final List<Waypoint> waypoints;

    /** Makes the upload of a list; an empty list is allowed and leaves the boat nothing to drive to. */
    public UploadWaypoints(String commandId, String listId, List<Waypoint> waypoints) {
        super(commandId);
        this.listId = Checks.id("list", listId);
        this.waypoints = WaypointRows.copy(waypoints);
    }

    static UploadWaypoints read(Fields in) throws LinkException {
        return new UploadWaypoints(in.text("command"), in.text("list"), WaypointRows.read(in));
    }

    /** The name of this list, never used for another. */
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
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeStringField("list", listId);
        WaypointRows.write(out, waypoints);
    }
}
