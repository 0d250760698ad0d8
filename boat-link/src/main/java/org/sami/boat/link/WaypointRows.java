package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Checks.BadValueException;
import org.sami.boat.link.LinkException.Fault;

/** Waypoint lists in the body: an array of rows {@code [lat, lon, speed]}, of aircraft {@code [lat, lon, speed, altitude]}. */
final class WaypointRows {
    private static final String NAME = "waypoints";

    private WaypointRows() {}

    static List<Waypoint> copy(List<Waypoint> waypoints) {
        return Collections.unmodifiableList(new ArrayList<>(waypoints));
    }

    static void write(JsonGenerator out, List<Waypoint> waypoints) throws IOException {
        out.writeFieldName(NAME);
        writeRows(out, waypoints);
    }

    /** The array alone. */
    static void writeRows(JsonGenerator out, List<Waypoint> waypoints) throws IOException {
        out.writeStartArray();
        for (Waypoint waypoint : waypoints) {
            writeRow(out, waypoint);
        }
        out.writeEndArray();
    }

    static void writeRow(JsonGenerator out, Waypoint waypoint) throws IOException {
        out.writeStartArray();
        out.writeNumber(waypoint.latDeg());
        out.writeNumber(waypoint.lonDeg());
        out.writeNumber(waypoint.speedMps());
        if (waypoint.altM() != 0) { // earlier boats take rows of three numbers only
            out.writeNumber(waypoint.altM());
        }
        out.writeEndArray();
    }

    static List<Waypoint> read(Fields in) throws LinkException {
        return read(in.array(NAME), "/" + NAME);
    }

    /** The rows of an array that stands at a place of the body. */
    static List<Waypoint> read(JsonNode array, String where) throws LinkException {
        JsonNode rows = Fields.array(array, where);
        List<Waypoint> waypoints = new ArrayList<>(rows.size());
        for (int i = 0; i < rows.size(); i++) {
            waypoints.add(readRow(rows.get(i), where + "/" + i));
        }
        return waypoints;
    }

    static Waypoint readRow(JsonNode row, String where) throws LinkException {
        if (!row.isArray() || (row.size() != 3 && row.size() != 4)) {
            throw new LinkException(Fault.WRONG_TYPE, where, "not a row of latitude, longitude and speed");
        }
        double latDeg = Fields.number(row.get(0), where + "/0");
        double lonDeg = Fields.number(row.get(1), where + "/1");
        double speedMps = Fields.number(row.get(2), where + "/2");
        double altM = row.size() == 4 ? Fields.number(row.get(3), where + "/3") : 0;
        try {
            return new Waypoint(latDeg, lonDeg, speedMps, altM);
        } catch (BadValueException e) {
            throw new LinkException(Fault.BAD_VALUE, where, String.valueOf(e.getMessage()));
        }
    }
}
