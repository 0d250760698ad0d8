package org.sami.session.record;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;

/**
 * Writes what a session notes next to the engine's inputs: poses, locations passed, how links went, messages, readings. Rows of the
 * journal's telemetry table, which no mission depends on. Safe for use by several threads.
 */
public final class SessionTelemetry {
    private static final System.Logger LOG = System.getLogger(SessionTelemetry.class.getName());
    private static final ObjectMapper JSON = TelemetryForms.JSON;
    /** Kind of the rows that say where a boat was. */
    public static final String POSE = "pose";

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

    private final Keeper keeper;
    private final LongSupplier nowMillis;
    private final ListenerList<Consumer<TelemetryRow>> listeners = new ListenerList<>();
    private final Map<ReadingBatch.Channel, ReadingBatch> batches = new LinkedHashMap<>();
    private Optional<SessionNote> problem = Optional.empty();

    /** Where rows are kept, such as a journal. */
    public interface Keeper {
        /**
         * Keeps a row.
         *
         * @throws IOException if it cannot be kept
         */
        void keep(TelemetryRow row) throws IOException;
    }

    /** Telemetry that is kept there. The clock gives the session's time in milliseconds. */
    public SessionTelemetry(Keeper keeper, LongSupplier nowMillis) {
        this.keeper = keeper;
        this.nowMillis = nowMillis;
    }

    /** A process begins or goes on. */
    public void begun() {
        add(nowMillis.getAsLong(), "", BEGUN, TelemetryForms.Nothing.AT_ALL);
    }

    /** Adds a listener, which is given each row on the thread that adds it, whether or not the journal keeps it; it must be quick. */
    public Registration addListener(Consumer<TelemetryRow> listener) {
        return listeners.add(listener);
    }

    /** Notes where a boat was, and how far it had come. */
    public void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {
        add(atMillis, boat, POSE, TelemetryForms.Pose.of(report, distanceM));
    }

    /** Several of one channel are written as one row: they are most of what a run writes down. */
    public void reading(SensorValue reading) {
        Optional<Due> due;
        synchronized (this) {
            ReadingBatch batch = batches.computeIfAbsent(
                    new ReadingBatch.Channel(reading.boat(), reading.sensor(), reading.channel(), reading.unit()),
                    ReadingBatch::new);
            due = batch.isDue(reading.atMillis()) ? take(batch) : Optional.empty();
            batch.add(reading);
        }
        due.ifPresent(this::write);
    }

    /** Writes what waits to be written with more of its kind. */
    public void flush() {
        List<Due> due = new ArrayList<>();
        synchronized (this) {
            batches.values().forEach(batch -> take(batch).ifPresent(due::add));
        }
        due.forEach(this::write);
    }

    /** Readings that are due, as one row. */
    private record Due(long atMillis, String boat, Object json) {}

    private static Optional<Due> take(ReadingBatch batch) {
        return batch.isEmpty()
                ? Optional.empty()
                : Optional.of(new Due(batch.lastMillis(), batch.boat(), batch.take()));
    }

    private void write(Due due) {
        add(due.atMillis(), due.boat(), READINGS, due.json());
    }

    /** Notes that a boat was at a location. */
    public void visited(long atMillis, String boat, GeoPoint location) {
        add(atMillis, boat, VISITED, TelemetryForms.Place.of(location));
    }

    /** Notes that a link to a boat stands, and which start of its server answers. */
    public void linked(String boat, String bootId) {
        add(nowMillis.getAsLong(), boat, LINKED, new TelemetryForms.Linked(bootId));
    }

    /** Notes that the link to a boat is lost. */
    public void lost(String boat) {
        add(nowMillis.getAsLong(), boat, LOST, TelemetryForms.Nothing.AT_ALL);
    }

    /** Notes where a boat's server listens. */
    public void address(String boat, String address) {
        add(nowMillis.getAsLong(), boat, ADDRESS, new TelemetryForms.Address(address));
    }

    /** Notes how many waypoint lists this process has sent to a boat. */
    public void uploads(String boat, UploadCount uploads) {
        add(nowMillis.getAsLong(), boat, UPLOADS, uploads);
    }

    /** Why a boat moved or did not when the run stopped. */
    public void why(long atMillis, String boat, String text) {
        add(atMillis, boat, WHY, new TelemetryForms.Why(text));
    }

    /** Keeps what the session says. */
    public void message(SessionNote note) {
        add(note.atMillis(), "", MESSAGE, TelemetryForms.Message.of(note));
    }

    /** Keeps a message to the operator. */
    public void message(OperatorMessage message) {
        add(message.atMillis(), "", MESSAGE, TelemetryForms.Message.of(message));
    }

    /**
     * Adds a row. Missions do not need it: a table that cannot be written stops none, and is reported once.
     *
     * @param boat the boat concerned; empty text for none
     * @param kind kind of the row, such as {@code pose}
     * @param json a tree, or a record whose components are its members
     */
    public void add(long atMillis, String boat, String kind, Object json) {
        try {
            TelemetryRow row = new TelemetryRow(atMillis, boat, kind, JSON.writeValueAsString(json));
            listeners.each(listener -> listener.accept(row));
            keep(row);
        } catch (IOException e) {
            failed(atMillis, e);
        }
    }

    private synchronized void keep(TelemetryRow row) throws IOException {
        if (problem.isEmpty()) {
            keeper.keep(row);
        }
    }

    private synchronized void failed(long atMillis, IOException e) {
        String text = "telemetry is no longer kept in the journal: " + e.getMessage();
        problem = Optional.of(new SessionNote(atMillis, SessionNote.JOURNAL, Ids.NONE, text));
        LOG.log(System.Logger.Level.WARNING, text);
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
        default void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {}

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

        /** What was reported. */
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
                read(row, reader);
            } catch (IOException | IllegalArgumentException fault) {
                LOG.log(System.Logger.Level.DEBUG, "telemetry that makes no sense: " + row, fault);
                senseless.add((row.kind() + " " + row.proxy()).strip());
            }
        }
        return senseless;
    }

    private static void read(TelemetryRow row, Reader reader) throws IOException {
        if (row.kind().equals(POSE)) { // most rows are poses: read without a tree
            TelemetryForms.Pose pose = TelemetryForms.POSES.readValue(row.json());
            reader.pose(row.atMillis(), row.proxy(), pose.report(), pose.distanceM());
        } else {
            read(row, JSON.readTree(row.json()), reader);
        }
    }

    private static void read(TelemetryRow row, JsonNode json, Reader reader) throws IOException {
        String boat = row.proxy();
        switch (row.kind()) {
            case VISITED ->
                reader.visited(
                        row.atMillis(),
                        boat,
                        TelemetryForms.whole(json, TelemetryForms.Place.class).point());
            case LINKED ->
                reader.linked(
                        boat,
                        JSON.treeToValue(json, TelemetryForms.Linked.class).bootId());
            case LOST -> reader.lost(boat);
            case ADDRESS ->
                reader.address(
                        boat,
                        JSON.treeToValue(json, TelemetryForms.Address.class).address());
            case UPLOADS -> reader.uploads(boat, JSON.treeToValue(json, UploadCount.class));
            case WHY ->
                reader.why(
                        boat, JSON.treeToValue(json, TelemetryForms.Why.class).text());
            case MESSAGE -> {
                TelemetryForms.Message message = JSON.treeToValue(json, TelemetryForms.Message.class);
                SessionNote note = message.note(row.atMillis());
                reader.message(note);
                if (note.isMessage()) {
                    reader.message(message.message(note));
                }
            }
            case READING ->
                reader.reading(
                        JSON.treeToValue(json, TelemetryForms.Reading.class).value(row.atMillis(), boat));
            case READINGS -> ReadingBatch.read(boat, json).forEach(reader::reading);
            case BEGUN -> reader.begun();
            default -> reader.other(row, json);
        }
    }
}
