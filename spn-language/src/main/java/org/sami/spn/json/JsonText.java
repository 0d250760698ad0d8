package org.sami.spn.json;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;

/** Turns text into a JSON tree, strictly: no duplicate members, nothing after the end. */
final class JsonText {
    static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    private static final String BYTE_ORDER_MARK = "\uFEFF";

    private JsonText() {}

    /** The tree, or empty and a problem with line and column. A byte order mark, as some editors write it, is passed over. */
    static Optional<JsonNode> parse(String text, Problems problems) {
        try {
            JsonNode node = MAPPER.readTree(withoutMark(text));
            if (node == null || node.isMissingNode()) {
                problems.add(Codes.SYNTAX, "", "The document is empty");
                return Optional.empty();
            }
            return Optional.of(node);
        } catch (JsonProcessingException e) {
            Finding finding = Finding.error(Codes.SYNTAX, "", firstLine(e.getOriginalMessage()));
            problems.add(place(e.getLocation()).map(finding::at).orElse(finding));
            return Optional.empty();
        }
    }

    /**
     * The text of a file in UTF-8, without a byte order mark.
     *
     * @throws java.nio.charset.CharacterCodingException if it is no UTF-8
     */
    static String decode(byte[] bytes) throws IOException {
        String text = StandardCharsets.UTF_8
                .newDecoder()
                .decode(ByteBuffer.wrap(bytes))
                .toString();
        return withoutMark(text);
    }

    static String withoutMark(String text) {
        return text.startsWith(BYTE_ORDER_MARK) ? text.substring(BYTE_ORDER_MARK.length()) : text;
    }

    private static Optional<SourceLocation> place(JsonLocation location) {
        return location == null || location.getLineNr() < 1 || location.getColumnNr() < 1
                ? Optional.empty()
                : Optional.of(new SourceLocation("", location.getLineNr(), location.getColumnNr()));
    }

    private static String firstLine(String message) {
        return message == null ? "not JSON" : message.lines().findFirst().orElse("not JSON");
    }

    /** A tree as one line. */
    static String text(JsonNode node) {
        try {
            return MAPPER.writeValueAsString(node);
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("A tree of nodes is always JSON", e);
        }
    }
}
