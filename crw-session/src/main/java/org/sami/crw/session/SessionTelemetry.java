package org.sami.crw.session;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Writes what a session notes beside the engine's inputs: poses, locations passed, how links went, messages, readings. Rows of the
 * journal's telemetry table, which no mission depends on. Safe for use by several threads.
 */
public final class SessionTelemetry {
    private static final System.Logger LOG = System.getLogger(SessionTelemetry.class.getName());
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final String POSE = "pose";
    private static final String VISITED = "visited";
    private static final String LINKED = "linked";
    private static final String LOST = "lost";
    private static final String ADDRESS = "address";
    private static final String UPLOADS = "uploads";
    private static final String MESSAGE = "message";
    private static final String BEGUN = "begun";
    private static final String READING = "reading"; // of one; written by earlier versions
    private static final String READINGS = "readings";
    private static final String WHY = "why";

    private final SessionJournal journal;
    private final LongSupplier nowMillis;
    private final Map<ReadingBatch.Channel, ReadingBatch> batches = new LinkedHashMap<>();
    private Optional<SessionNote> problem = Optional.empty();

    SessionTelemetry(SessionJournal journal, LongSupplier nowMillis) {
        this.journal = journal;
        this.nowMillis = nowMillis;
    }

    /** A process begins or goes on. */
    void begun() {
        add(nowMillis.getAsLong(), "", BEGUN, JSON.createObjectNode());
    }

    /** Notes where a boat was, and how far it had come. */
    public void pose(long atMillis, String boat, FleetHistory.Told told, double distanceM) {
        ObjectNode json = point(told.position());
        json.put("headingRad", told.headingRad())
                .put("speedMps", told.speedMps())
                .put("batteryPercent", told.batteryPercent())
                .put("boatTimeMs", told.boatTimeMs())
                .put("distanceM", distanceM);
        add(atMillis, boat, POSE, json);
    }

    /** Several of one channel are written as one row: they are most of what a run writes down. */
    synchronized void reading(SensorValue reading) {
        ReadingBatch batch = batches.computeIfAbsent(
                new ReadingBatch.Channel(reading.boat(), reading.sensor(), reading.channel(), reading.unit()),
                ReadingBatch::new);
        if (batch.isDue(reading.atMillis())) {
            write(batch);
        }
        batch.add(reading);
    }

    /** Writes what waits to be written with more of its kind. */
    public synchronized void flush() {
        batches.values().forEach(this::write);
    }

    private void write(ReadingBatch batch) {
        if (!batch.isEmpty()) {
            add(batch.lastMillis(), batch.boat(), READINGS, batch.take());
        }
    }

    /** Notes that a boat was at a location. */
    public void visited(long atMillis, String boat, GeoPoint location) {
        add(atMillis, boat, VISITED, point(location));
    }

    void linked(String boat, String bootId) {
        add(nowMillis.getAsLong(), boat, LINKED, JSON.createObjectNode().put("bootId", bootId));
    }

    void lost(String boat) {
        add(nowMillis.getAsLong(), boat, LOST, JSON.createObjectNode());
    }

    void address(String boat, String address) {
        add(nowMillis.getAsLong(), boat, ADDRESS, JSON.createObjectNode().put("address", address));
    }

    void uploads(String boat, UploadCount uploads) {
        add(
                nowMillis.getAsLong(),
                boat,
                UPLOADS,
                JSON.createObjectNode()
                        .put("sent", uploads.sent())
                        .put("acknowledged", uploads.acknowledged())
                        .put("readBackEqual", uploads.readBackEqual())
                        .put("failed", uploads.failed()));
    }

    /** Why a boat moved or did not when the run stopped. */
    public void why(long atMillis, String boat, String text) {
        add(atMillis, boat, WHY, JSON.createObjectNode().put("text", text));
    }

    void message(SessionNote note) {
        add(note.atMillis(), "", MESSAGE, json(note));
    }

    void message(OperatorMessage message) {
        ObjectNode json = json(SessionNote.of(message))
                .put("source", message.source().name())
                .put("priority", message.priority().name())
                .put("keyword", message.keyword());
        message.boats().forEach(json.withArray("boats")::add);
        add(message.atMillis(), "", MESSAGE, json);
    }

    private static ObjectNode json(SessionNote note) {
        return JSON.createObjectNode()
                .put("kind", note.kind())
                .put("mission", note.mission())
                .put("text", note.text());
    }

    private static ObjectNode point(GeoPoint point) {
        return JSON.createObjectNode().put("latDeg", point.latDeg()).put("lonDeg", point.lonDeg());
    }

    /**
     * Adds a row. Missions do not need it: a table that cannot be written stops none, and is reported once.
     *
     * @param boat the boat concerned; empty text for none
     * @param kind kind of the row, such as {@code pose}
     */
    public synchronized void add(long atMillis, String boat, String kind, ObjectNode json) {
        try {
            if (problem.isEmpty()) {
                journal.addTelemetry(new TelemetryRow(atMillis, boat, kind, json.toString()));
            }
        } catch (IOException e) {
            String text = "telemetry is no longer kept in the journal: " + e.getMessage();
            problem = Optional.of(new SessionNote(atMillis, SessionNote.JOURNAL, Ids.NONE, text));
            LOG.log(System.Logger.Level.WARNING, text);
        }
    }

    /** What is missing in the journal and why; empty where nothing is. */
    public synchronized Optional<SessionNote> problem() {
        return problem;
    }

    /** Who wants to know what earlier processes wrote. */
    public interface Reader {
        /** A process began, or went on. */
        default void begun() {}

        /** Where a boat was, and how far it had come in metres. */
        default void pose(long atMillis, String boat, FleetHistory.Told told, double distanceM) {}

        /** A boat was at a location. */
        default void visited(long atMillis, String boat, GeoPoint location) {}

        /** A link stood. */
        default void linked(String boat, String bootId) {}

        /** A link was lost. */
        default void lost(String boat) {}

        /** Where a boat's server listened. */
        default void address(String boat, String address) {}

        /** How many waypoint lists a process had sent to a boat. */
        default void uploads(String boat, UploadCount uploads) {}

        /** Why a boat moved or did not. */
        default void why(String boat, String text) {}

        /** What was told. */
        default void message(SessionNote note) {}

        /** The same in full, where it was a message to the operator. */
        default void message(OperatorMessage message) {}

        /** What a boat measured. */
        default void reading(SensorValue reading) {}

        /** A row of a kind that the session does not know: whoever wrote it does. */
        default void other(TelemetryRow row, JsonNode json) {}
    }

    /**
     * Reads what earlier processes wrote, in order. A row that makes no sense is left out.
     *
     * @return what the rows that were left out are of, in the order of the rows
     */
    public static List<String> read(List<TelemetryRow> rows, Reader reader) {
        List<String> senseless = new ArrayList<>();
        for (TelemetryRow row : rows) {
            try {
                read(row, JSON.readTree(row.json()), reader);
            } catch (IOException | IllegalArgumentException fault) {
                LOG.log(System.Logger.Level.DEBUG, "telemetry that makes no sense: " + row, fault);
                senseless.add((row.kind() + " " + row.proxy()).strip());
            }
        }
        return senseless;
    }

    private static void read(TelemetryRow row, JsonNode json, Reader reader) {
        String boat = row.proxy();
        switch (row.kind()) {
            case POSE ->
                reader.pose(
                        row.atMillis(),
                        boat,
                        told(json),
                        json.required("distanceM").asDouble());
            case VISITED -> reader.visited(row.atMillis(), boat, point(json));
            case LINKED -> reader.linked(boat, json.path("bootId").asText());
            case LOST -> reader.lost(boat);
            case ADDRESS -> reader.address(boat, json.path("address").asText());
            case UPLOADS ->
                reader.uploads(
                        boat,
                        new UploadCount(
                                json.path("sent").asInt(),
                                json.path("acknowledged").asInt(),
                                json.path("readBackEqual").asInt(),
                                json.path("failed").asInt()));
            case WHY -> reader.why(boat, json.path("text").asText());
            case MESSAGE -> {
                SessionNote note = new SessionNote(
                        row.atMillis(),
                        json.path("kind").asText(),
                        json.path("mission").asLong(),
                        json.path("text").asText());
                reader.message(note);
                if (note.isMessage()) {
                    reader.message(message(note, json));
                }
            }
            case READING -> reader.reading(reading(row.atMillis(), boat, json));
            case READINGS -> ReadingBatch.read(boat, json).forEach(reader::reading);
            case BEGUN -> reader.begun();
            default -> reader.other(row, json);
        }
    }

    /** Earlier versions wrote no more than the text and who spoke. */
    private static OperatorMessage message(SessionNote note, JsonNode json) {
        List<String> boats = new ArrayList<>();
        json.path("boats").forEach(boat -> boats.add(boat.asText()));
        return new OperatorMessage(
                note.atMillis(),
                note.mission(),
                OperatorMessage.Source.valueOf(json.path("source").asText(note.source())),
                Priority.valueOf(json.path("priority").asText(Priority.MEDIUM.name())),
                note.text(),
                boats,
                json.path("keyword").asText());
    }

    private static SensorValue reading(long atMillis, String boat, JsonNode json) {
        List<Double> values = new ArrayList<>();
        json.path("values").forEach(value -> values.add(value.asDouble()));
        return new SensorValue(
                atMillis,
                boat,
                json.path("sensor").asText(),
                json.path("channel").asText(),
                values,
                json.path("unit").asText(),
                GeoPoint.of(json.path("latDeg").asDouble(), json.path("lonDeg").asDouble()));
    }

    private static FleetHistory.Told told(JsonNode json) {
        return new FleetHistory.Told(
                point(json),
                json.required("headingRad").asDouble(),
                json.required("speedMps").asDouble(),
                json.required("batteryPercent").asDouble(),
                json.required("boatTimeMs").asLong());
    }

    private static GeoPoint point(JsonNode json) {
        return GeoPoint.of(
                json.required("latDeg").asDouble(), json.required("lonDeg").asDouble());
    }
}
