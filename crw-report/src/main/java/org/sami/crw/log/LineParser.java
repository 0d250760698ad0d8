package org.sami.crw.log;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Understands a line of a boat's log. Both dialects, that of 2013 and that of 2015, have entries of the form
 * {@code 2481613 18:36:23,235 TOPIC: content} and differ in the topics; a file may mix them. Those of 2016 have JSON after the time,
 * {@code 2481613 18:36:23,235 {"topic":content}}, or after a letter for how important the line is, with tabs between.
 */
final class LineParser {
    private static final Pattern ENTRY = Pattern.compile(
            "(\\d{1,18}) (\\d{1,2}:\\d{1,2}:\\d{1,2}[,.]\\d{1,3}) ([A-Za-z][A-Za-z0-9_]*(?: [A-Za-z0-9_]+)*):(?: (.*))?");
    private static final Pattern JSON_ENTRY =
            Pattern.compile("(\\d{1,18})[ \t](?:(\\d{1,2}:\\d{1,2}:\\d{1,2}[,.]\\d{1,3})|[A-Z])[ \t](\\{.*)");
    private static final String NUMBER = "([-+]?(?:[0-9.]+(?:[eE][-+]?[0-9]+)?|NaN|Infinity))";

    /** {@code {476608.34, 4671214.4, 172.35, Q[0.0,0.0,-1.15]} @ 17North}: easting, northing, altitude, roll, pitch, yaw. */
    private static final Pattern POSE = spaced("\\{ N , N , N , Q \\[ N , N , N \\] \\} @ (\\w+)");

    /** {@code [591774.6 m, 4482781.5 m], 17T, 190.0, 0.0}: easting, northing, zone, altitude, bearing. */
    private static final Pattern FIX = spaced("\\[ N m , N m \\] , (\\w+) , N , N");

    private static final Pattern TWIST = Pattern.compile("Twist(\\[.*\\])");

    /** {@code [e, 0.0, 30.0]}, {@code [39.88, -7.3]}: the microcontroller's letter for the sensor, then numbers. */
    private static final Pattern ARRAY = Pattern.compile("\\[(?:[A-Za-z] ?, ?)?([^\\[\\]]*)\\]");

    /** {@code 4 Sensor4(BATTERY)[12.4, 9045.4, 0.0]}. */
    private static final Pattern NAMED_ARRAY = Pattern.compile("\\d+ (\\w+\\(\\w+\\))\\[([^\\[\\]]*)\\]");

    private static final List<String> COMMANDS =
            List.of("CMD", "PIDGAINS", "SETGAINS", "WAYPOINT", "WAYPOINTS", "AUTONOMOUS", "WINCH", "SAMPLER");
    private static final Pattern ARRAYS =
            Pattern.compile("ES2|TE|DEPTH|WATERCANARY|THRUST|RUDDER|[A-Z]+(?:_[A-Z]+)*_VALUES");
    private static final Pattern SCALARS = Pattern.compile("COMPASS(?:_[A-Z]+)*|[A-Z]+(?:_[A-Z]+)*_ACCURACY|MOTOR\\d+");
    private static final Pattern JSON_SENSOR = Pattern.compile("SENSOR\\d+");
    private static final ObjectMapper JSON = new ObjectMapper().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);

    private final UtmGrid grid = new UtmGrid();
    private final JsonEntries json = new JsonEntries(grid);

    private static Pattern spaced(String form) {
        return Pattern.compile(form.replace(" ", " ?").replace("N", NUMBER));
    }

    /**
     * The entry that a line holds.
     *
     * @throws BadLineException if it holds none that is known
     */
    LoggedLine parse(long number, String line) throws BadLineException {
        Matcher parts = ENTRY.matcher(line.stripTrailing());
        if (!parts.matches()) {
            return parseJson(number, line.stripTrailing());
        }
        String topic = parts.group(3);
        String content = parts.group(4) == null ? "" : parts.group(4).strip();
        return new LoggedLine(number, Long.parseLong(parts.group(1)), parts.group(2), topic, entry(topic, content));
    }

    private LoggedLine parseJson(long number, String line) throws BadLineException {
        Matcher parts = JSON_ENTRY.matcher(line);
        if (!parts.matches()) {
            throw new BadLineException(
                    LineFault.NO_ENTRY, "expected are milliseconds, a time of day and TOPIC: content");
        }
        JsonNode object = object(parts.group(3));
        String topic = JsonEntries.topic(object);
        String clock = parts.group(2) == null ? object.path("date").asText() : parts.group(2);
        return new LoggedLine(number, Long.parseLong(parts.group(1)), clock, topic, json.entry(topic, object));
    }

    private LogEntry entry(String topic, String content) throws BadLineException {
        if (topic.equals("POSE")) {
            Matcher pose = matched(POSE, content, "{easting, northing, altitude, Q[roll,pitch,yaw]} @ zone");
            return new LogEntry.Pose(
                    grid.point(pose.group(7), number(pose.group(1)), number(pose.group(2))), number(pose.group(6)));
        }
        if (topic.equals("GPS")) {
            Matcher fix = matched(FIX, content, "[easting m, northing m], zone, altitude, bearing");
            return new LogEntry.Fix(grid.point(fix.group(3), number(fix.group(1)), number(fix.group(2))));
        }
        if (topic.equals("VEL")) {
            return reading(topic, matched(TWIST, content, "Twist[six numbers]").group(1), ARRAY, "Twist[six numbers]");
        }
        if (topic.equals("Battery Voltage")) {
            Matcher named = matched(NAMED_ARRAY, content, "port sensor(type)[numbers]");
            return new LogEntry.Reading(
                    topic + " " + named.group(1), numbered(named.group(2).split(",", -1)));
        }
        if (COMMANDS.contains(topic)) {
            return command(topic, content);
        }
        if (JSON_SENSOR.matcher(topic).matches()) {
            return jsonReading(topic, content);
        }
        if (ARRAYS.matcher(topic).matches()) {
            return reading(topic, content, ARRAY, "[numbers]");
        }
        if (SCALARS.matcher(topic).matches()) {
            return new LogEntry.Reading(topic, numbered(content));
        }
        throw new BadLineException(LineFault.UNKNOWN_TOPIC, "there is no topic '" + topic + "'");
    }

    private static LogEntry command(String topic, String content) throws BadLineException {
        if (content.isEmpty()) {
            throw bad("a command has a content");
        }
        if (topic.equals("CMD")) {
            object(content);
        }
        return new LogEntry.Command(content);
    }

    private static LogEntry reading(String sensor, String content, Pattern form, String expected)
            throws BadLineException {
        return new LogEntry.Reading(
                sensor, numbered(matched(form, content, expected).group(1).split(",", -1)));
    }

    /** {@code {"data":"12.463 9045.4 0.0","type":"battery"}}, or with the channels as members: {@code {"type":"es2","t":19.5}}. */
    private static LogEntry jsonReading(String topic, String content) throws BadLineException {
        JsonNode json = object(content);
        JsonNode type = json.path("type");
        if (!type.isTextual()) {
            throw bad("a sensor's JSON has a member 'type'");
        }
        String sensor = topic + " " + type.asText();
        JsonNode data = json.path("data");
        if (data.isTextual()) {
            return new LogEntry.Reading(sensor, numbered(data.asText().strip().split("\\s+")));
        }
        Map<String, Double> values = new LinkedHashMap<>();
        json.properties().stream()
                .filter(member -> member.getValue().isNumber())
                .forEach(member -> values.put(member.getKey(), member.getValue().asDouble()));
        if (values.isEmpty()) {
            throw bad("a sensor's JSON has a text 'data' or members that are numbers");
        }
        return new LogEntry.Reading(sensor, values);
    }

    private static JsonNode object(String content) throws BadLineException {
        try {
            JsonNode json = JSON.readTree(content);
            if (json.isObject()) {
                return json;
            }
        } catch (JsonProcessingException e) {
            throw bad("no JSON object: " + e.getOriginalMessage());
        }
        throw bad("no JSON object");
    }

    private static Map<String, Double> numbered(String... texts) throws BadLineException {
        Map<String, Double> values = new LinkedHashMap<>();
        for (String text : texts) {
            values.put(String.valueOf(values.size() + 1), number(text.strip()));
        }
        return values;
    }

    private static double number(String text) throws BadLineException {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw bad("'" + text + "' is no number");
        }
    }

    private static Matcher matched(Pattern form, String content, String expected) throws BadLineException {
        Matcher matcher = form.matcher(content);
        if (!matcher.matches()) {
            throw bad("expected is " + expected);
        }
        return matcher;
    }

    private static BadLineException bad(String message) {
        return new BadLineException(LineFault.BAD_CONTENT, message);
    }
}
