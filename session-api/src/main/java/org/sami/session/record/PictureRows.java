package org.sami.session.record;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ObjLongConsumer;
import org.sami.boat.link.KeptFile;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.Panorama;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** The pictures of boats as rows of the journal's telemetry: that they were taken, and what became of each. */
public final class PictureRows {
    /** Kind of the rows that say which pictures a boat took. */
    public static final String TAKEN = "pictures";

    /** Kind of the rows that say what became of one. */
    public static final String PICTURE = "picture";

    private static final System.Logger LOG = System.getLogger(PictureRows.class.getName());
    private static final ObjectMapper JSON = new ObjectMapper();

    private static final String FILE = "file";

    private final SessionPictures pictures;

    /** Rows of the session that keeps its pictures there. */
    public PictureRows(SessionPictures pictures) {
        this.pictures = pictures;
    }

    /** Writes an event down, if it is about pictures. */
    public void write(SessionTelemetry telemetry, long atMillis, FleetEvent event) {
        if (event instanceof FleetEvent.PanoramaTaken taken && !taken.files().isEmpty()) {
            ObjectNode json = JSON.createObjectNode()
                    .put("panorama", taken.command().commandId())
                    .put("mission", taken.command().mission())
                    .put("latDeg", taken.from().latDeg())
                    .put("lonDeg", taken.from().lonDeg());
            taken.files().forEach(json.putArray("files")::add);
            telemetry.add(atMillis, event.boat(), TAKEN, json);
        } else if (event instanceof FleetEvent.PictureFetched fetched) {
            ObjectNode json = picture(fetched.panorama(), fetched.name());
            telemetry.add(atMillis, event.boat(), PICTURE, json.put(FILE, pictures.noted(fetched.file())));
        } else if (event instanceof FleetEvent.PictureMissed missed) {
            ObjectNode json = picture(missed.panorama(), missed.name());
            telemetry.add(atMillis, event.boat(), PICTURE, json.put("missed", missed.reason()));
        }
    }

    private static ObjectNode picture(String panorama, String name) {
        return JSON.createObjectNode().put("panorama", panorama).put("name", name);
    }

    /** The event of a row; empty if the row is of another kind. */
    public Optional<FleetEvent> event(TelemetryRow row, JsonNode json) {
        return switch (row.kind()) {
            case TAKEN -> Optional.of(taken(row.proxy(), json));
            case PICTURE -> Optional.of(one(row.proxy(), json));
            default -> Optional.empty();
        };
    }

    private static FleetEvent taken(String boat, JsonNode json) {
        List<String> files = new ArrayList<>();
        json.required("files").forEach(file -> files.add(checked(file.asText())));
        Panorama command = new Panorama(
                json.required("panorama").asText(),
                json.required("mission").asLong(),
                Ids.NONE,
                Math.max(1, files.size()),
                Priority.MEDIUM);
        GeoPoint from = GeoPoint.of(
                json.required("latDeg").asDouble(), json.required("lonDeg").asDouble());
        return new FleetEvent.PanoramaTaken(boat, command, files.size(), from, files);
    }

    private FleetEvent one(String boat, JsonNode json) {
        String panorama = json.required("panorama").asText();
        String name = checked(json.required("name").asText());
        return json.has(FILE)
                ? new FleetEvent.PictureFetched(
                        boat, panorama, name, pictures.file(json.get(FILE).asText()))
                : new FleetEvent.PictureMissed(
                        boat, panorama, name, json.required("missed").asText());
    }

    private static String checked(String name) {
        if (!KeptFile.isName(name)) {
            throw new IllegalArgumentException("'" + name + "' is no name of a picture");
        }
        return name;
    }

    /** Replays the events about pictures from the rows, in order, with their times. Damaged rows are left out and logged. */
    public void read(List<TelemetryRow> rows, ObjLongConsumer<FleetEvent> then) {
        for (TelemetryRow row : rows) {
            if (row.kind().equals(TAKEN) || row.kind().equals(PICTURE)) {
                try {
                    event(row, JSON.readTree(row.json())).ifPresent(event -> then.accept(event, row.atMillis()));
                } catch (IOException | IllegalArgumentException fault) {
                    LOG.log(System.Logger.Level.WARNING, "a row about pictures makes no sense: " + row, fault);
                }
            }
        }
    }
}
