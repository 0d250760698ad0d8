package org.sami.boat.hull.board;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.Map;
import java.util.Optional;

/**
 * Reads the board's lines. Of a line whose beginning is damaged, as after a lost line end, the last whole object counts; what cannot be read is passed on as
 * garbled. One thread.
 */
final class BoardLines {
    /** The longest line of the board. */
    static final int MAX_BYTES = 576;

    private static final int MAX_DEPTH = 8;
    private static final int MAX_TRIES = 16;

    /** Receives what the lines say. */
    interface Reader {
        /** What a motor does: its velocity, -1 to 1; NaN if the board gives none. */
        void motor(int number, double velocity);

        /** What a sensor measured, as the board's text. */
        void sensor(String slot, String type, String data);

        /** The board reports an error. */
        void error(String error, String arguments);

        /** A line that cannot be read. */
        void garbled(String line);
    }

    private final ObjectMapper json;
    private final Reader reader;

    BoardLines(Reader reader) {
        this.reader = reader;
        StreamReadConstraints limits =
                StreamReadConstraints.builder().maxNestingDepth(MAX_DEPTH).build();
        json = new ObjectMapper(
                JsonFactory.builder().streamReadConstraints(limits).build());
        json.enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);
    }

    /** Reads a line; whether the board has said anything in it. */
    boolean read(String line) {
        int from = line.indexOf('{');
        for (int tries = 0; from >= 0 && tries < MAX_TRIES; tries++) {
            Optional<JsonNode> object = object(line.substring(from));
            if (object.isPresent() && take(object.get())) {
                return true;
            }
            from = line.indexOf('{', from + 1);
        }
        reader.garbled(line);
        return false;
    }

    private Optional<JsonNode> object(String text) {
        try {
            return Optional.ofNullable(json.readTree(text)).filter(JsonNode::isObject);
        } catch (JsonProcessingException damaged) {
            return Optional.empty();
        }
    }

    private boolean take(JsonNode object) {
        boolean known = false;
        if (object.path("error").isTextual()) {
            reader.error(object.path("error").asText(), object.path("args").asText());
            known = true;
        }
        for (Map.Entry<String, JsonNode> member : object.properties()) {
            known |= take(member.getKey(), member.getValue());
        }
        return known;
    }

    private boolean take(String name, JsonNode value) {
        if (name.length() != 2 || !Character.isDigit(name.charAt(1)) || !value.isObject()) {
            return false;
        }
        if (name.charAt(0) == 'm') {
            JsonNode velocity = value.path("v");
            reader.motor(name.charAt(1) - '0', velocity.isNumber() ? velocity.asDouble() : Double.NaN);
            return true;
        }
        if (name.charAt(0) == 's' && value.path("type").isTextual()) {
            reader.sensor(name, value.path("type").asText(), value.path("data").asText());
            return true;
        }
        return false;
    }
}
