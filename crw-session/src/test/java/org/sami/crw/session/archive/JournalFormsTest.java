package org.sami.crw.session.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.session.record.CommandJson;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionNote;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** What a session notes has the bytes that it always had, and what earlier versions noted is read. */
class JournalFormsTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final GeoPoint PLACE = GeoPoint.of(45.5, -0.1);

    @TempDir
    private Path folder;

    private static final Map<BoatCommand, String> COMMANDS = Map.of(
            new FollowPath(
                    "c1", 7, 12, List.of(PLACE, GeoPoint.of(45, 1e-7)), OptionalDouble.of(1.5), 1, Priority.HIGH, true),
            "{\"id\":\"c1\",\"mission\":7,\"activation\":12,\"priority\":\"HIGH\",\"block\":true,\"kind\":\"path\",\"start\":1,\"speedMps\":1.5,"
                    + "\"points\":[45.5,-0.1,45.0,1.0E-7]}",
            new FollowPath("c2", 0, 0, List.of(PLACE), OptionalDouble.empty(), 0, Priority.LOW, false),
            "{\"id\":\"c2\",\"mission\":0,\"activation\":0,\"priority\":\"LOW\",\"block\":false,\"kind\":\"path\",\"start\":0,\"points\":[45.5,-0.1]}",
            new KeepStation("c3", 7, 13, PLACE, 10, Priority.CRITICAL, false),
            "{\"id\":\"c3\",\"mission\":7,\"activation\":13,\"priority\":\"CRITICAL\",\"block\":false,\"kind\":\"station\",\"latDeg\":45.5,\"lonDeg\":-0.1,"
                    + "\"radiusM\":10.0}",
            new Panorama("c4", 7, 14, 8, Priority.MEDIUM),
            "{\"id\":\"c4\",\"mission\":7,\"activation\":14,\"priority\":\"MEDIUM\",\"block\":false,\"kind\":\"panorama\",\"pictures\":8}",
            new Stop("c5", 7, 15, Priority.MEDIUM, true),
            "{\"id\":\"c5\",\"mission\":7,\"activation\":15,\"priority\":\"MEDIUM\",\"block\":true,\"kind\":\"stop\"}");

    @Test
    void commandsHaveTheirBytesAndComeBack() throws Exception {
        for (Map.Entry<BoatCommand, String> entry : COMMANDS.entrySet()) {
            assertThat(JSON.writeValueAsString(CommandJson.write(entry.getKey())))
                    .isEqualTo(entry.getValue());
            assertThat(CommandJson.read(JSON.readTree(entry.getValue()))).isEqualTo(entry.getKey());
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{}",
                "{\"id\":\"c\",\"mission\":7,\"activation\":15,\"priority\":\"MEDIUM\",\"block\":true,\"kind\":\"dance\"}",
                "{\"id\":\"c\",\"mission\":7,\"activation\":15,\"priority\":\"MEDIUM\",\"block\":true,\"kind\":\"panorama\"}",
                "{\"id\":\"c\",\"mission\":7,\"activation\":15,\"priority\":\"MEDIUM\",\"block\":true,\"kind\":\"station\",\"latDeg\":45}",
                "{\"mission\":7,\"activation\":15,\"priority\":\"MEDIUM\",\"block\":true,\"kind\":\"stop\"}",
                "{\"id\":\"c\",\"mission\":7,\"activation\":15,\"priority\":\"URGENT\",\"block\":true,\"kind\":\"stop\"}"
            })
    void whatIsNoCommandIsRefused(String json) throws Exception {
        var node = JSON.readTree(json);

        assertThatThrownBy(() -> CommandJson.read(node)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void rowsHaveTheirBytesAndComeBack() throws Exception {
        Path file = folder.resolve("journal");
        SessionJournal journal = SessionJournal.create(file, JournalHeader.of("{}", Map.of(), Map.of()));
        SessionTelemetry telemetry = new SessionTelemetry(journal::addTelemetry, () -> 7_000);
        FleetHistory.Report report = new FleetHistory.Report(PLACE, 0.25, 1.5, 88.5, 123);
        SessionNote note = new SessionNote(7_100, SessionNote.LINK, 3, "the link \"went\"");
        OperatorMessage message = new OperatorMessage(
                7_200, 3, OperatorMessage.Source.DOMAIN, Priority.HIGH, "come home", List.of("anna"), "home");

        telemetry.begun();
        telemetry.pose(6_000, "anna", report, 12.25);
        telemetry.visited(6_100, "anna", PLACE);
        telemetry.linked("anna", "7f1c");
        telemetry.lost("anna");
        telemetry.address("anna", "quay:5001");
        telemetry.uploads("anna", new UploadCount(4, 3, 2, 1));
        telemetry.why(6_200, "anna", "aground");
        telemetry.message(note);
        telemetry.message(message);
        journal.close();

        List<TelemetryRow> rows;
        try (JournalReader reader = JournalReader.open(file)) {
            rows = reader.telemetry().rows();
        }
        assertThat(rows.stream().map(row -> row.kind() + " " + row.json()))
                .containsExactly(
                        "begun {}",
                        "pose {\"latDeg\":45.5,\"lonDeg\":-0.1,\"headingRad\":0.25,\"speedMps\":1.5,\"batteryPercent\":88.5,\"boatTimeMs\":123,"
                                + "\"distanceM\":12.25}",
                        "visited {\"latDeg\":45.5,\"lonDeg\":-0.1}",
                        "linked {\"bootId\":\"7f1c\"}",
                        "lost {}",
                        "address {\"address\":\"quay:5001\"}",
                        "uploads {\"sent\":4,\"acknowledged\":3,\"readBackEqual\":2,\"failed\":1}",
                        "why {\"text\":\"aground\"}",
                        "message {\"kind\":\"link\",\"mission\":3,\"text\":\"the link \\\"went\\\"\"}",
                        "message {\"kind\":\"domain message\",\"mission\":3,\"text\":\"come"
                                + " home\",\"source\":\"DOMAIN\",\"priority\":\"HIGH\","
                                + "\"keyword\":\"home\",\"boats\":[\"anna\"]}");
        Heard heard = new Heard();
        assertThat(SessionTelemetry.read(rows, heard)).isEmpty();
        assertThat(heard.said)
                .containsExactly(
                        "begun",
                        "pose anna " + report + " 12.25",
                        "visited anna " + PLACE,
                        "linked anna 7f1c",
                        "lost anna",
                        "address anna quay:5001",
                        "uploads anna " + new UploadCount(4, 3, 2, 1),
                        "why anna aground",
                        "note " + note,
                        "note " + SessionNote.of(message),
                        "message " + message);
    }

    @Test
    void rowsOfEarlierVersionsAreReadAndSenselessOnesAreNamed() {
        Heard heard = new Heard();

        List<String> senseless = SessionTelemetry.read(
                List.of(
                        new TelemetryRow(
                                1, "", "message", "{\"kind\":\"domain message\",\"mission\":3,\"text\":\"old\"}"),
                        new TelemetryRow(
                                2,
                                "anna",
                                "reading",
                                "{\"sensor\":\"ph\",\"channel\":\"a\",\"values\":[7,8.5],\"unit\":\"pH\",\"latDeg\":45,"
                                        + "\"lonDeg\":1}"),
                        new TelemetryRow(3, "anna", "linked", "{}"),
                        new TelemetryRow(4, "anna", "uploads", "{\"sent\":2,\"later\":true}"),
                        new TelemetryRow(5, "anna", "pose", "{\"latDeg\":45.5}"),
                        new TelemetryRow(6, "anna", "visited", "{\"latDeg\":45.5}"),
                        new TelemetryRow(7, "anna", "lost", "what"),
                        new TelemetryRow(8, "anna", "own", "{\"a\":1}")),
                heard);

        assertThat(heard.said)
                .containsExactly(
                        "note SessionNote[atMillis=1, kind=domain message, mission=3, text=old]",
                        "message "
                                + new OperatorMessage(
                                        1, 3, OperatorMessage.Source.DOMAIN, Priority.MEDIUM, "old", List.of(), ""),
                        "reading " + new SensorValue(2, "anna", "ph", "a", List.of(7.0, 8.5), "pH", GeoPoint.of(45, 1)),
                        "linked anna ",
                        "uploads anna " + new UploadCount(2, 0, 0, 0),
                        "own {\"a\":1}");
        assertThat(senseless).containsExactly("pose anna", "visited anna", "lost anna");
    }

    /** Writes down what it hears. */
    private static final class Heard implements SessionTelemetry.Reader {
        private final List<String> said = new ArrayList<>();

        @Override
        public void begun() {
            said.add("begun");
        }

        @Override
        public void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {
            said.add("pose " + boat + " " + report + " " + distanceM);
        }

        @Override
        public void visited(long atMillis, String boat, GeoPoint location) {
            said.add("visited " + boat + " " + location);
        }

        @Override
        public void linked(String boat, String bootId) {
            said.add("linked " + boat + " " + bootId);
        }

        @Override
        public void lost(String boat) {
            said.add("lost " + boat);
        }

        @Override
        public void address(String boat, String address) {
            said.add("address " + boat + " " + address);
        }

        @Override
        public void uploads(String boat, UploadCount uploads) {
            said.add("uploads " + boat + " " + uploads);
        }

        @Override
        public void why(String boat, String text) {
            said.add("why " + boat + " " + text);
        }

        @Override
        public void message(SessionNote note) {
            said.add("note " + note);
        }

        @Override
        public void message(OperatorMessage message) {
            said.add("message " + message);
        }

        @Override
        public void reading(SensorValue reading) {
            said.add("reading " + reading);
        }

        @Override
        public void other(TelemetryRow row, JsonNode json) {
            said.add(row.kind() + " " + json);
        }
    }
}
