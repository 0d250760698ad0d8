package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.math.BigDecimal;
import java.time.Duration;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** Reads values of types without parameters, such as numbers, durations and points; every mismatch is a problem at its place. */
final class SimpleValueReader {
    private static final Pattern NUMBER_WITH_UNIT = Pattern.compile("(\\d{1,12}(?:\\.\\d{1,9})?) ?(ms|s|min|h)");
    private static final Map<String, BigDecimal> MILLIS_OF = Map.of(
            "ms", BigDecimal.ONE,
            "s", BigDecimal.valueOf(1000),
            "min", BigDecimal.valueOf(60_000),
            "h", BigDecimal.valueOf(3_600_000));

    private final Problems problems;

    SimpleValueReader(Problems problems) {
        this.problems = problems;
    }

    /** A value of a type without parameters; {@link ValueType.Simple#ANY} is none of these, as its values say their own. */
    Optional<Value> read(JsonNode node, ValueType.Simple type, String pointer) {
        return switch (type) {
            case BOOLEAN ->
                node.isBoolean()
                        ? Optional.of(new BooleanValue(node.booleanValue()))
                        : wrong(node, "true or false", pointer);
            case INTEGER ->
                node.isIntegralNumber() && node.canConvertToLong()
                        ? Optional.of(new IntegerValue(node.longValue()))
                        : wrong(node, "a whole number", pointer);
            case REAL -> number(node, pointer).map(RealValue::new);
            case TEXT -> text(node, "text", pointer).map(TextValue::new);
            case DURATION -> text(node, "a duration such as \"PT10S\"", pointer).flatMap(t -> duration(t, pointer));
            case PROXY -> text(node, "the id of a proxy", pointer).map(ProxyValue::new);
            case TASK -> readTask(node, pointer);
            case POINT -> readPoint(node, pointer).map(p -> p);
            case PATH -> readPoints(node, pointer).map(GeoPath::new);
            case AREA -> readArea(node, pointer);
            case VARIABLE -> text(node, "the name of a variable", pointer).flatMap(t -> variable(t, pointer));
            case PLAN -> text(node, "the id of a plan", pointer).map(PlanReference::new);
            case ANY -> throw new IllegalArgumentException("A value of any type says its own");
        };
    }

    private Optional<Value> readTask(JsonNode node, String pointer) {
        Optional<JsonObjectReader> members = JsonObjectReader.of(node, pointer, problems);
        if (members.isEmpty()) {
            return Optional.empty();
        }
        Optional<JsonNode> mission = members.get().node("mission");
        String name = members.get().text("name");
        members.get().done();
        if (mission.isEmpty() || !mission.get().isIntegralNumber()) {
            problems.add(Codes.WRONG_TYPE, pointer, "A task has the number of its mission in \"mission\"");
            return Optional.empty();
        }
        return name.isEmpty()
                ? Optional.empty()
                : Optional.of(new TaskId(mission.get().longValue(), name));
    }

    private Optional<GeoPoint> readPoint(JsonNode node, String pointer) {
        Optional<JsonObjectReader> members = JsonObjectReader.of(node, pointer, problems);
        if (members.isEmpty()) {
            return Optional.empty();
        }
        Optional<Double> lat = coordinate(members.get(), "lat", pointer);
        Optional<Double> lon = coordinate(members.get(), "lon", pointer);
        Optional<Double> alt = members.get().has("alt") ? coordinate(members.get(), "alt", pointer) : Optional.of(0.0);
        members.get().done();
        if (lat.isEmpty() || lon.isEmpty() || alt.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Optional.of(new GeoPoint(lat.get(), lon.get(), alt.get()));
        } catch (IllegalArgumentException e) {
            boolean swapped = Math.abs(lat.get()) > 90 && Math.abs(lat.get()) <= 180 && Math.abs(lon.get()) <= 90;
            problems.add(
                    Codes.BAD_VALUE,
                    pointer,
                    e.getMessage() + (swapped ? "; are latitude and longitude swapped?" : ""));
            return Optional.empty();
        }
    }

    private Optional<Double> coordinate(JsonObjectReader members, String name, String pointer) {
        Optional<JsonNode> node = members.node(name);
        if (node.isEmpty()) {
            problems.add(
                    Codes.MISSING, pointer, "A point has \"lat\" and \"lon\" in degrees; \"" + name + "\" is missing");
        }
        return node.flatMap(n -> number(n, Problems.at(pointer, name)));
    }

    private Optional<List<GeoPoint>> readPoints(JsonNode node, String pointer) {
        if (!node.isArray()) {
            wrong(node, "a list of points", pointer);
            return Optional.empty();
        }
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < node.size(); i++) {
            readPoint(node.get(i), Problems.at(pointer, i)).ifPresent(points::add);
        }
        return points.size() == node.size() ? Optional.of(points) : Optional.empty();
    }

    private Optional<Value> readArea(JsonNode node, String pointer) {
        Optional<JsonObjectReader> members = JsonObjectReader.of(node, pointer, problems);
        if (members.isEmpty()) {
            return Optional.empty();
        }
        Optional<List<GeoPoint>> outline =
                members.get().node("outline").flatMap(n -> readPoints(n, Problems.at(pointer, "outline")));
        List<List<GeoPoint>> holes = new ArrayList<>();
        List<JsonObjectReader.Element> given = members.get().array("holes");
        given.forEach(h -> readPoints(h.node(), h.pointer()).ifPresent(holes::add));
        members.get().done();
        if (outline.isEmpty() || outline.get().size() < 3) {
            problems.add(Codes.BAD_VALUE, pointer, "An area has an \"outline\" of three points or more");
            return Optional.empty();
        }
        return holes.size() == given.size() ? Optional.of(new GeoArea(outline.get(), holes)) : Optional.empty();
    }

    private Optional<Value> duration(String text, String pointer) {
        try {
            Duration duration = withUnit(text).orElseGet(() -> Duration.parse(text));
            if (!duration.isNegative() && duration.equals(Duration.ofMillis(duration.toMillis()))) {
                return Optional.of(new DurationValue(duration.toMillis()));
            }
        } catch (DateTimeParseException | ArithmeticException e) {
            // reported below, as what stands there
        }
        problems.add(
                Codes.BAD_VALUE,
                pointer,
                "\"" + text + "\" is no duration in whole milliseconds; write PT10S for 10 seconds, PT1M30S, PT0.5S,"
                        + " or a number with its unit, such as 10 s or 500 ms");
        return Optional.empty();
    }

    /** A number with its unit: the appendix counts in milliseconds, the fleet's plans in seconds. */
    private static Optional<Duration> withUnit(String text) {
        Matcher matcher = NUMBER_WITH_UNIT.matcher(text.strip());
        if (!matcher.matches()) {
            return Optional.empty();
        }
        BigDecimal millis = new BigDecimal(matcher.group(1)).multiply(MILLIS_OF.get(matcher.group(2)));
        return Optional.of(Duration.ofNanos(millis.movePointRight(6).longValueExact()));
    }

    private Optional<Value> variable(String text, String pointer) {
        if (text.length() > 1 && text.startsWith("@")) {
            return Optional.of(new VariableReference(text));
        }
        problems.add(Codes.VARIABLE_NAME, pointer, "A variable's name begins with @, not \"" + text + "\"");
        return Optional.empty();
    }

    private Optional<Double> number(JsonNode node, String pointer) {
        if (node.isNumber() && Double.isFinite(node.doubleValue())) {
            return Optional.of(node.doubleValue());
        }
        wrong(node, "a number", pointer);
        return Optional.empty();
    }

    /** A text, or empty and a problem that says what was expected. */
    Optional<String> text(JsonNode node, String what, String pointer) {
        if (node.isTextual()) {
            return Optional.of(node.textValue());
        }
        wrong(node, what, pointer);
        return Optional.empty();
    }

    /** Reports that something else than expected stands at a place; always empty. */
    Optional<Value> wrong(JsonNode node, String expected, String pointer) {
        problems.add(
                Codes.WRONG_TYPE,
                pointer,
                "Expected is " + expected + ", found was " + JsonObjectReader.describe(node));
        return Optional.empty();
    }
}
