package org.sami.session.record;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.ObjectReader;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.message.OperatorMessage.Source;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * What stands in the rows that {@link SessionTelemetry} writes, a record for each kind: its components are the members of the JSON object, in their order.
 * Members that this version does not know are left alone.
 */
final class TelemetryForms {
    static final ObjectMapper JSON = JsonMapper.builder()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .build();

    static final ObjectReader POSES =
            JSON.readerFor(Pose.class).with(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES);

    private TelemetryForms() {}

    /**
     * Reads a form of which no number may be missing.
     *
     * @throws JsonProcessingException where one is
     */
    static <T> T whole(JsonNode json, Class<T> form) throws JsonProcessingException {
        return JSON.reader()
                .with(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
                .treeToValue(json, form);
    }

    /** An object without members. */
    record Nothing() {
        static final Nothing AT_ALL = new Nothing();
    }

    record Place(double latDeg, double lonDeg) {
        static Place of(GeoPoint point) {
            return new Place(point.latDeg(), point.lonDeg());
        }

        GeoPoint point() {
            return GeoPoint.of(latDeg, lonDeg);
        }
    }

    record Pose(
            double latDeg,
            double lonDeg,
            double headingRad,
            double speedMps,
            double batteryPercent,
            long boatTimeMs,
            double distanceM) {
        static Pose of(FleetHistory.Report report, double distanceM) {
            return new Pose(
                    report.position().latDeg(),
                    report.position().lonDeg(),
                    report.headingRad(),
                    report.speedMps(),
                    report.batteryPercent(),
                    report.boatTimeMs(),
                    distanceM);
        }

        FleetHistory.Report report() {
            return new FleetHistory.Report(
                    GeoPoint.of(latDeg, lonDeg), headingRad, speedMps, batteryPercent, boatTimeMs);
        }
    }

    record Linked(String bootId) {
        Linked {
            bootId = Objects.requireNonNullElse(bootId, "");
        }
    }

    record Address(String address) {
        Address {
            address = Objects.requireNonNullElse(address, "");
        }
    }

    record Why(String text) {
        Why {
            text = Objects.requireNonNullElse(text, "");
        }
    }

    /** A note; with source, priority, keyword and boats, a message to the operator. Earlier versions wrote no more than the note of one. */
    @JsonInclude(JsonInclude.Include.NON_NULL)
    record Message(
            String kind,
            long mission,
            String text,
            @Nullable Source source,
            @Nullable Priority priority,
            @Nullable String keyword,
            @Nullable List<String> boats,
            @Nullable Boolean pictures) {
        Message {
            kind = Objects.requireNonNullElse(kind, "");
            text = Objects.requireNonNullElse(text, "");
        }

        static Message of(SessionNote note) {
            return new Message(note.kind(), note.mission(), note.text(), null, null, null, null, null);
        }

        static Message of(OperatorMessage message) {
            SessionNote note = SessionNote.of(message);
            return new Message(
                    note.kind(),
                    note.mission(),
                    note.text(),
                    message.source(),
                    message.priority(),
                    message.keyword(),
                    message.boats(),
                    message.map()
                                    .boats()
                                    .filter(MapRelevance.Boats::showPictures)
                                    .isPresent()
                            ? true
                            : null);
        }

        SessionNote note(long atMillis) {
            return new SessionNote(atMillis, kind, mission, text);
        }

        OperatorMessage message(SessionNote note) {
            return new OperatorMessage(
                    note.atMillis(),
                    mission,
                    source == null ? Source.valueOf(note.source()) : source,
                    Objects.requireNonNullElse(priority, Priority.MEDIUM),
                    text,
                    Objects.requireNonNullElse(boats, List.of()),
                    Objects.requireNonNullElse(keyword, ""),
                    Boolean.TRUE.equals(pictures) && boats != null
                            ? MapRelevance.ofPictures(boats)
                            : MapRelevance.NONE);
        }
    }

    /** One reading, as earlier versions wrote it. */
    record Reading(String sensor, String channel, List<Double> values, String unit, double latDeg, double lonDeg) {
        SensorValue value(long atMillis, String boat) {
            return new SensorValue(
                    atMillis,
                    boat,
                    Objects.requireNonNullElse(sensor, ""),
                    Objects.requireNonNullElse(channel, ""),
                    Objects.requireNonNullElse(values, List.of()),
                    Objects.requireNonNullElse(unit, ""),
                    GeoPoint.of(latDeg, lonDeg));
        }
    }
}
