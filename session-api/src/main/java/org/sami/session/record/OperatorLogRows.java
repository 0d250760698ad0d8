package org.sami.session.record;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.value.GeoPoint;

/** The operator's log as rows of the journal's telemetry, so that it survives the process. */
public final class OperatorLogRows {
    /** Kind of the rows. */
    public static final String KIND = "operator";

    private static final System.Logger LOG = System.getLogger(OperatorLogRows.class.getName());
    private static final ObjectMapper JSON = new ObjectMapper();

    private OperatorLogRows() {}

    /** An entry as the JSON of a row. */
    public static ObjectNode json(OperatorLogEntry entry) {
        ObjectNode json = JSON.createObjectNode()
                .put("number", entry.number())
                .put("kind", entry.kind().name())
                .put("text", entry.text())
                .put("mission", entry.mission());
        entry.boats().forEach(json.putArray("boats")::add);
        entry.position().ifPresent(at -> json.put("latDeg", at.latDeg()).put("lonDeg", at.lonDeg()));
        return json;
    }

    /** The entries among the rows, in order. A row that makes no sense is left out. */
    public static List<OperatorLogEntry> read(List<TelemetryRow> rows) {
        List<OperatorLogEntry> entries = new ArrayList<>();
        for (TelemetryRow row : rows) {
            if (row.kind().equals(KIND)) {
                try {
                    entries.add(read(row.atMillis(), JSON.readTree(row.json())));
                } catch (IOException | IllegalArgumentException fault) {
                    LOG.log(
                            System.Logger.Level.WARNING,
                            "an entry of the operator's log makes no sense: " + row,
                            fault);
                }
            }
        }
        return entries;
    }

    private static OperatorLogEntry read(long atMillis, JsonNode json) {
        List<String> boats = new ArrayList<>();
        json.required("boats").forEach(boat -> boats.add(boat.asText()));
        Optional<GeoPoint> position = json.has("latDeg")
                ? Optional.of(GeoPoint.of(
                        json.required("latDeg").asDouble(),
                        json.required("lonDeg").asDouble()))
                : Optional.empty();
        return new OperatorLogEntry(
                json.required("number").asLong(),
                atMillis,
                OperatorLogEntry.Kind.valueOf(json.required("kind").asText()),
                json.required("text").asText(),
                json.required("mission").asLong(),
                boats,
                position);
    }
}
