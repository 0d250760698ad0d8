package org.sami.session.follow;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.Map;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.json.UnreadableJsonException;

/** A session's journal as JSON for those who follow it in another process (docs/session-link.md, Following). */
public final class FollowJson {
    private static final ObjectMapper JSON = new ObjectMapper();

    private FollowJson() {}

    /** What stands before the first entry. */
    public static ObjectNode write(JournalHeader header) {
        ObjectNode node =
                JSON.createObjectNode().put("version", header.formatVersion()).put("project", header.project());
        header.vocabulary().forEach(node.putObject("vocabulary")::put);
        header.settings().forEach(node.putObject("settings")::put);
        return node;
    }

    /** Reads what {@link #write(JournalHeader)} wrote. */
    public static JournalHeader header(JsonNode node) {
        return new JournalHeader(
                node.path("version").asInt(),
                node.path("project").asText(),
                texts(node.path("vocabulary")),
                texts(node.path("settings")));
    }

    /** The texts of an object, in order. */
    public static Map<String, String> texts(JsonNode node) {
        Map<String, String> texts = new LinkedHashMap<>();
        node.fieldNames()
                .forEachRemaining(name -> texts.put(name, node.path(name).asText()));
        return texts;
    }

    /** An input as it was taken in. */
    public static ObjectNode write(JournalEntry entry) {
        ObjectNode node = JSON.createObjectNode().put("i", entry.index()).put("at", entry.atMillis());
        node.set("input", ProtocolJson.input(entry.input()));
        return node;
    }

    /** A row of telemetry. */
    public static ObjectNode write(TelemetryRow row) {
        ObjectNode node = JSON.createObjectNode().put("at", row.atMillis());
        if (!row.proxy().isEmpty()) {
            node.put("boat", row.proxy());
        }
        return node.put("kind", row.kind()).put("row", row.json());
    }

    /** Whether it is an input, else it is a row. */
    public static boolean isEntry(JsonNode node) {
        return node.has("i");
    }

    /**
     * Reads an input.
     *
     * @throws UnreadableJsonException if this program does not know it
     */
    public static JournalEntry entry(JsonNode node) throws UnreadableJsonException {
        return new JournalEntry(
                node.path("i").asLong(), node.path("at").asLong(), ProtocolJson.readInput(node.path("input")));
    }

    /** Reads a row. */
    public static TelemetryRow row(JsonNode node) {
        return new TelemetryRow(
                node.path("at").asLong(),
                node.path("boat").asText(),
                node.path("kind").asText(),
                node.path("row").asText());
    }

    /**
     * Parses a message.
     *
     * @throws IllegalArgumentException if it is no JSON
     */
    public static JsonNode parse(String text) {
        try {
            return JSON.readTree(text);
        } catch (JsonProcessingException unreadable) {
            throw new IllegalArgumentException("this is no JSON: " + unreadable.getOriginalMessage(), unreadable);
        }
    }
}
