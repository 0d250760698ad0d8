package org.sami.crw.sim.tcp;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;

/**
 * What was found when the boats had answered for the first time; it stays so for the whole run. It is kept in the session's memory
 * in the engine, since a run that has lost it cannot be taken up as it was (docs/session.md).
 *
 * @param centre of the area in which the locations lie
 * @param boats their names in the order of their addresses
 */
record RunArea(GeoPoint centre, List<String> boats) {
    private static final String KEY = "run/area";
    private static final String TELEMETRY_KIND = "area";
    private static final ObjectMapper JSON = new ObjectMapper();

    RunArea {
        Objects.requireNonNull(centre, "centre");
        boats = List.copyOf(boats);
    }

    /** An area around boats. */
    static RunArea around(List<GeoPoint> positions, List<String> boats) {
        return new RunArea(
                GeoPoint.of(
                        positions.stream()
                                .mapToDouble(GeoPoint::latDeg)
                                .average()
                                .orElse(0),
                        positions.stream()
                                .mapToDouble(GeoPoint::lonDeg)
                                .average()
                                .orElse(0)),
                boats);
    }

    /** Records it as telemetry. */
    void note(SessionTelemetry telemetry, long atMillis) {
        ObjectNode json = JSON.createObjectNode().put("latDeg", centre.latDeg()).put("lonDeg", centre.lonDeg());
        boats.forEach(json.putArray("boats")::add);
        telemetry.add(atMillis, "", TELEMETRY_KIND, json);
    }

    /**
     * The area that an earlier process recorded as telemetry; empty if the row is of another kind.
     *
     * @throws IllegalArgumentException if it makes no sense
     */
    static Optional<RunArea> noted(TelemetryRow row, JsonNode json) {
        if (!row.kind().equals(TELEMETRY_KIND)) {
            return Optional.empty();
        }
        List<String> boats = new ArrayList<>();
        json.path("boats").forEach(boat -> boats.add(boat.asText()));
        GeoPoint centre = GeoPoint.of(
                json.required("latDeg").asDouble(), json.required("lonDeg").asDouble());
        return Optional.of(new RunArea(centre, boats));
    }

    /** Has the engine remember it. */
    Input remember() {
        List<Value> values = new ArrayList<>(List.of(centre));
        boats.forEach(boat -> values.add(new ProxyValue(boat)));
        return new Input.Remember(Ids.NONE, KEY, new ListValue(values));
    }

    /** What the engine remembers of it. */
    static Optional<RunArea> remembered(EngineView view) {
        return view.memory(Ids.NONE, KEY)
                .filter(ListValue.class::isInstance)
                .map(value -> ((ListValue) value).items())
                .filter(items -> !items.isEmpty() && items.get(0) instanceof GeoPoint)
                .map(items -> new RunArea(
                        (GeoPoint) items.get(0),
                        items.stream()
                                .filter(ProxyValue.class::isInstance)
                                .map(boat -> ((ProxyValue) boat).proxy())
                                .toList()));
    }
}
