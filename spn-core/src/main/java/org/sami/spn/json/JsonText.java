package org.sami.spn.json;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.Optional;

/** Turns text into a JSON tree, strictly: no duplicate members, nothing after the end. */
final class JsonText {
    static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    private JsonText() {}

    /** The tree, or empty and a problem with line and column. */
    static Optional<JsonNode> parse(String text, Problems problems) {
        try {
            JsonNode node = MAPPER.readTree(text);
            if (node == null || node.isMissingNode()) {
                problems.add(Codes.SYNTAX, "", "The document is empty");
                return Optional.empty();
            }
            return Optional.of(node);
        } catch (JsonProcessingException e) {
            problems.add(Codes.SYNTAX, "", place(e.getLocation()) + firstLine(e.getOriginalMessage()));
            return Optional.empty();
        }
    }

    private static String place(JsonLocation location) {
        return location == null ? "" : "Line " + location.getLineNr() + ", column " + location.getColumnNr() + ": ";
    }

    private static String firstLine(String message) {
        return message == null ? "not JSON" : message.lines().findFirst().orElse("not JSON");
    }
}
