package org.sami.session.server;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.sami.session.api.RefusedException;
import org.sami.spn.value.GeoPoint;

/**
 * One message of a front, its members checked. Immutable.
 *
 * @param type such as {@code answer}
 * @param id by which replies name it; 0 for {@code hello}
 */
record FrontMessage(String type, long id, JsonNode body) {
    private static final ObjectMapper JSON = JsonMapper.builder(JsonFactory.builder()
                    .streamReadConstraints(StreamReadConstraints.builder()
                            .maxNestingDepth(20)
                            .maxNumberLength(30)
                            .build())
                    .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                    .build())
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();
    private static final int MOST_TEXT = 2000;
    private static final int MOST_SHOWN = 40;
    private static final String DIGITS = "[0-9]{1,15}";
    private static final Map<String, Set<String>> MEMBERS = Map.ofEntries(
            Map.entry("hello", Set.of("v", "name", "key")),
            Map.entry("answer", Set.of("decision", "answer")),
            Map.entry("judge", Set.of("decision", "answer")),
            Map.entry("hold", Set.of("decision")),
            Map.entry("press", Set.of("mission", "name", "boats")),
            Map.entry("start", Set.of("plan", "name")),
            Map.entry("abort", Set.of("mission")),
            Map.entry("stopFleet", Set.of()),
            Map.entry("releaseFleet", Set.of()),
            Map.entry("claim", Set.of("boat")),
            Map.entry("drive", Set.of("boat", "thrust", "rudder")),
            Map.entry("goTo", Set.of("boat", "lat", "lon")),
            Map.entry("goHome", Set.of("boat")),
            Map.entry("holdBoat", Set.of("boat")),
            Map.entry("giveBack", Set.of("boat")),
            Map.entry("acknowledge", Set.of("message", "alarm")),
            Map.entry("follow", Set.of("session", "after")),
            Map.entry("input", Set.of("input")),
            Map.entry("draft", Set.of("input")),
            Map.entry("again", Set.of("mission")),
            Map.entry("boat", Set.of("do", "boat", "client", "command", "address", "lat", "lon", "count")),
            Map.entry("set", Set.of("boat", "setting", "p", "i", "d", "multiplier", "action")),
            Map.entry("linkedBoats", Set.of()),
            Map.entry("linkStatuses", Set.of("boat")),
            Map.entry("layer", Set.of("sensor", "visualization")),
            Map.entry("note", Set.of("text", "lat", "lon")),
            Map.entry("ping", Set.of()));

    /** Reads a message. */
    static FrontMessage read(String text) throws MalformedMessageException {
        JsonNode body;
        try {
            body = JSON.readTree(text);
        } catch (JsonProcessingException | IllegalArgumentException unreadable) {
            throw new MalformedMessageException(
                    "this is no JSON object"); // what was sent is not repeated: it may hold a key
        }
        if (body == null || !body.isObject()) {
            throw new MalformedMessageException("this is no JSON object");
        }
        String type = body.path("t").isTextual() ? body.path("t").asText() : "";
        Set<String> members = MEMBERS.get(type);
        if (members == null) {
            throw new MalformedMessageException("there is no message '" + shown(type) + "'");
        }
        boolean hello = type.equals("hello");
        JsonNode id = body.path("id");
        if (!hello && !(id.isIntegralNumber() && id.canConvertToLong() && id.asLong() > 0)) {
            throw new MalformedMessageException("'" + type + "' needs an id, a number from 1 on");
        }
        for (Iterator<String> names = body.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (!name.equals("t") && !name.equals("id") && !members.contains(name)) {
                throw new MalformedMessageException("'" + type + "' has no member '" + shown(name) + "'");
            }
        }
        return new FrontMessage(type, id.asLong(), body);
    }

    private static String shown(String text) {
        String plain = text.replaceAll("[^\\x20-\\x7e]", "?");
        return plain.length() <= MOST_SHOWN ? plain : plain.substring(0, MOST_SHOWN) + "...";
    }

    /** A text that must be there. */
    String text(String member) throws MalformedMessageException {
        return textIfThere(member)
                .orElseThrow(() -> new MalformedMessageException("'" + type + "' needs the text '" + member + "'"));
    }

    Optional<String> textIfThere(String member) throws MalformedMessageException {
        JsonNode node = body.path(member);
        if (node.isMissingNode()) {
            return Optional.empty();
        }
        if (!node.isTextual() || node.asText().length() > MOST_TEXT) {
            throw new MalformedMessageException("'" + member + "' is a text of at most " + MOST_TEXT + " characters");
        }
        return Optional.of(node.asText());
    }

    /** A number of a mission, decision or message, as a number or as digits. */
    long number(String member) throws MalformedMessageException {
        JsonNode node = body.path(member);
        if (node.isIntegralNumber() && node.canConvertToLong()) {
            return node.asLong();
        }
        if (node.isTextual() && node.asText().matches(DIGITS)) {
            return Long.parseLong(node.asText());
        }
        throw new MalformedMessageException("'" + type + "' needs the number '" + member + "'");
    }

    boolean has(String member) {
        return body.has(member);
    }

    double real(String member) throws MalformedMessageException {
        OptionalDouble value = body.path(member).isNumber()
                ? OptionalDouble.of(body.path(member).asDouble())
                : OptionalDouble.empty();
        return value.orElseThrow(
                () -> new MalformedMessageException("'" + type + "' needs the number '" + member + "'"));
    }

    /** Its place; one outside of the valid degrees is refused. */
    GeoPoint point() throws MalformedMessageException {
        double latDeg = real("lat");
        double lonDeg = real("lon");
        try {
            return GeoPoint.of(latDeg, lonDeg);
        } catch (IllegalArgumentException noPlace) {
            throw new RefusedException(String.valueOf(noPlace.getMessage()));
        }
    }

    List<String> texts(String member) throws MalformedMessageException {
        List<String> texts = new ArrayList<>();
        JsonNode node = body.path(member);
        if (!node.isMissingNode() && !node.isArray()) {
            throw new MalformedMessageException("'" + member + "' is a list of texts");
        }
        for (JsonNode one : node) {
            if (!one.isTextual()) {
                throw new MalformedMessageException("'" + member + "' is a list of texts");
            }
            texts.add(one.asText());
        }
        return texts;
    }
}
