package org.sami.crw.sim.run.settings;

import java.time.Duration;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.Reading;
import org.sami.spn.json.ValueJson;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/**
 * Values as people type them on a command line, read by the type that is expected: {@code 90 s}, {@code 52.1,4.3},
 * {@code boat1;boat2}. What has no short form, and what begins like JSON, is read as the JSON of files.
 */
public final class ValueText {
    private static final Pattern SPAN = Pattern.compile("(\\d+(?:\\.\\d+)?)\\s*(ms|s|min|h)?");
    private static final Map<String, Integer> MILLIS = Map.of("ms", 1, "s", 1000, "min", 60_000, "h", 3_600_000);

    private ValueText() {}

    /** Reads a value; empty where the text is none of that type, with reasons where JSON was read. */
    public static Optional<Value> parse(
            String text, ValueType type, Map<String, NamedType> types, List<Finding> findings) {
        String trimmed = text.strip();
        if (trimmed.startsWith("{") || trimmed.startsWith("[")) {
            return json(trimmed, type, types, findings);
        }
        try {
            if (type instanceof ValueType.Simple simple) {
                return Optional.of(simple(trimmed, simple));
            }
            if (type instanceof ValueType.ListOf list) {
                return list(trimmed, list.element(), types, findings);
            }
        } catch (IllegalArgumentException | DateTimeParseException e) {
            return Optional.empty();
        }
        if (type instanceof ValueType.Named named
                && types.get(named.name()) instanceof NamedType.Enumeration enumeration) {
            return enumeration.constants().stream()
                    .filter(constant -> constant.equalsIgnoreCase(trimmed))
                    .findFirst()
                    .map(constant -> new EnumValue(named.name(), constant));
        }
        return json(trimmed, type, types, findings);
    }

    private static Optional<Value> json(
            String text, ValueType type, Map<String, NamedType> types, List<Finding> findings) {
        Reading<Value> reading = ValueJson.read(text, type, types);
        findings.addAll(reading.findings());
        return reading.result();
    }

    private static Value simple(String text, ValueType.Simple type) {
        return switch (type) {
            case BOOLEAN -> new BooleanValue(truth(text));
            case INTEGER -> new IntegerValue(Long.parseLong(text));
            case REAL -> new RealValue(Double.parseDouble(text));
            case TEXT, ANY -> new TextValue(text);
            case DURATION -> new DurationValue(millis(text));
            case PROXY -> new ProxyValue(named(text));
            case POINT -> point(text);
            case PATH -> new GeoPath(points(text));
            case AREA -> new GeoArea(points(text), List.of());
            case VARIABLE -> new VariableReference(text.startsWith("@") ? text : "@" + named(text));
            case PLAN -> new PlanReference(named(text));
            case TASK -> throw new IllegalArgumentException("a task cannot be named before it exists");
        };
    }

    private static Optional<Value> list(
            String text, ValueType element, Map<String, NamedType> types, List<Finding> findings) {
        List<Value> items = new ArrayList<>();
        for (String part : text.isEmpty() ? new String[0] : text.split(";", -1)) {
            Optional<Value> item = parse(part, element, types, findings);
            if (item.isEmpty()) {
                return Optional.empty();
            }
            items.add(item.get());
        }
        return Optional.of(new ListValue(items));
    }

    private static boolean truth(String text) {
        return switch (text.toLowerCase(Locale.ROOT)) {
            case "true", "yes" -> true;
            case "false", "no" -> false;
            default -> throw new IllegalArgumentException(text);
        };
    }

    private static String named(String text) {
        if (text.isEmpty()) {
            throw new IllegalArgumentException("empty");
        }
        return text;
    }

    private static long millis(String text) {
        Matcher span = SPAN.matcher(text);
        if (span.matches()) {
            String unit = span.group(2) == null ? "s" : span.group(2);
            return Math.round(Double.parseDouble(span.group(1)) * MILLIS.getOrDefault(unit, 0));
        }
        return Duration.parse(text).toMillis();
    }

    private static GeoPoint point(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != 2 && parts.length != 3) {
            throw new IllegalArgumentException(text);
        }
        double altM = parts.length == 3 ? Double.parseDouble(parts[2].strip()) : 0;
        return new GeoPoint(Double.parseDouble(parts[0].strip()), Double.parseDouble(parts[1].strip()), altM);
    }

    private static List<GeoPoint> points(String text) {
        return each(text, ValueText::point);
    }

    private static <T> List<T> each(String text, Function<String, T> reader) {
        List<T> items = new ArrayList<>();
        for (String part : text.split(";", -1)) {
            items.add(reader.apply(part.strip()));
        }
        return items;
    }

    /** How a value of a type is typed, with an example. */
    public static String form(ValueType type) {
        if (type instanceof ValueType.ListOf list) {
            return "a list with ';' between items, each " + form(list.element());
        }
        if (type instanceof ValueType.Simple simple) {
            return switch (simple) {
                case BOOLEAN -> "true or false";
                case INTEGER -> "a whole number";
                case REAL -> "a number such as 2.5";
                case TEXT, ANY -> "text";
                case DURATION -> "a duration such as 90s, 1.5min or PT90S";
                case PROXY -> "a boat's name such as boat1";
                case TASK -> "a task, which cannot be named before it exists";
                case POINT -> "a point 'latitude,longitude' in degrees";
                case PATH -> "points 'latitude,longitude' with ';' between them";
                case AREA -> "three points or more, 'latitude,longitude' with ';' between them";
                case VARIABLE -> "a variable's name such as @speed";
                case PLAN -> "a plan's id";
            };
        }
        return type instanceof ValueType.Named named ? "a " + named.name() : "a JSON value";
    }
}
