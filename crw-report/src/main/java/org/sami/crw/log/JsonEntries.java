package org.sami.crw.log;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * Understands what a line of a log of 2016 says: a JSON object whose first member is its topic, such as
 * {@code {"sensor":{"channel":3,"type":"ES2","data":[249,19.4]}}}.
 */
final class JsonEntries {
    private static final Set<String> COMMANDS =
            Set.of("cmd", "gain", "waypoints", "autonomous", "home", "winch", "sampler");

    private final UtmGrid grid;

    JsonEntries(UtmGrid grid) {
        this.grid = grid;
    }

    /** The topic of an object that is not empty. */
    static String topic(JsonNode object) throws BadLineException {
        if (object.isEmpty()) {
            throw bad("an entry has a member that is its topic");
        }
        return object.fieldNames().next();
    }

    LogEntry entry(String topic, JsonNode object) throws BadLineException {
        JsonNode content = object.get(topic);
        if (topic.equals("pose")) {
            return pose(content);
        } else if (topic.equals("sensor")) {
            return sensor(content);
        } else if (COMMANDS.contains(topic)) {
            return new LogEntry.Command(content.toString());
        } else if (topic.equals("date") && object.path("time").isNumber()) {
            return new LogEntry.Reading(topic, Map.of("time", object.get("time").asDouble()));
        } else if (content.isNumber()) {
            return new LogEntry.Reading(topic, Map.of("1", content.asDouble()));
        } else if (isNumbers(content)) {
            return new LogEntry.Reading(topic, numbered(content));
        }
        throw new BadLineException(LineFault.UNKNOWN_TOPIC, "there is no topic '" + topic + "'");
    }

    /** {@code {"p":[easting,northing,altitude],"q":[...],"zone":"17North"}}. */
    private LogEntry pose(JsonNode content) throws BadLineException {
        JsonNode p = content.path("p");
        if (!isNumbers(p) || p.size() < 2 || !content.path("zone").isTextual()) {
            throw bad("a pose has 'p' with easting and northing, and a 'zone'");
        }
        return new LogEntry.Pose(
                grid.point(
                        content.get("zone").asText(),
                        p.get(0).asDouble(),
                        p.get(1).asDouble()),
                yaw(content.path("q")));
    }

    /** The turn about the vertical, which those logs keep in the third of a quaternion's four numbers. */
    private static double yaw(JsonNode q) {
        return isNumbers(q) && q.size() == 4
                ? 2 * Math.atan2(q.get(2).asDouble(), q.get(0).asDouble())
                : Double.NaN;
    }

    private static LogEntry sensor(JsonNode content) throws BadLineException {
        JsonNode data = content.path("data");
        if (!content.path("type").isTextual() || !isNumbers(data)) {
            throw bad("a sensor has a 'type' and 'data', a list of numbers");
        }
        return new LogEntry.Reading(
                "sensor" + content.path("channel").asText() + " "
                        + content.get("type").asText(),
                numbered(data));
    }

    private static boolean isNumbers(JsonNode list) {
        boolean numbers = list.isArray() && !list.isEmpty();
        for (JsonNode item : list) {
            numbers &= item.isNumber();
        }
        return numbers;
    }

    private static Map<String, Double> numbered(JsonNode list) {
        Map<String, Double> values = new LinkedHashMap<>();
        list.forEach(item -> values.put(String.valueOf(values.size() + 1), item.asDouble()));
        return values;
    }

    private static BadLineException bad(String message) {
        return new BadLineException(LineFault.BAD_CONTENT, message);
    }
}
