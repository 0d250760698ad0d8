package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.json.ValueJson;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Makes values of this language of the export's, by the requested type. Empty where that is impossible: the caller says
 * where that happened and what it does without it.
 */
final class LegacyValues {
    private static final int DEEPEST = 32;

    private final Vocabulary vocabulary;
    private final LegacyTable table;
    private final Copies copies;

    LegacyValues(Vocabulary vocabulary, LegacyTable table, Copies copies) {
        this.vocabulary = vocabulary;
        this.table = table;
        this.copies = copies;
    }

    /**
     * A value of a type.
     *
     * @param rule says units of durations and other names of constants
     */
    Optional<Value> convert(LegacyValue value, ValueType type, LegacyTable.FieldRule rule) {
        Optional<JsonNode> renamed = constant(value).map(rule.values()::get);
        if (renamed.isPresent()) {
            return ValueJson.read(renamed.get(), type, vocabulary.types()).result();
        }
        try {
            return of(value, type, rule.unitMillis(), 0).filter(v -> TypeCheck.accepts(type, v, vocabulary.types()));
        } catch (IllegalArgumentException outOfRange) {
            return Optional.empty(); // a latitude of 100, an area of two points
        }
    }

    /** The text by which a rule may give a value another name. */
    static Optional<String> constant(LegacyValue value) {
        JsonNode node = value.node();
        if (node.isTextual() || node.isBoolean() || node.isNumber()) {
            return Optional.of(node.asText());
        }
        JsonNode plain = value.type().equals("enum") ? node.path("enum") : node.path("value");
        return plain.isValueNode() && !plain.isNull() ? Optional.of(plain.asText()) : Optional.empty();
    }

    private Optional<Value> of(LegacyValue value, ValueType type, double unitMillis, int depth) {
        if (value.isNull() || depth > DEEPEST) {
            return Optional.empty();
        }
        if (type instanceof ValueType.ListOf list) {
            return items(value)
                    .flatMap(items -> all(items, list.element(), unitMillis, depth))
                    .map(ListValue::new);
        }
        if (type instanceof ValueType.MapOf map) {
            return entries(value, map, unitMillis, depth);
        }
        if (type instanceof ValueType.Named named) {
            return named(value, named.name(), unitMillis, depth);
        }
        return simple(value, (ValueType.Simple) type, unitMillis);
    }

    private Optional<Value> simple(LegacyValue value, ValueType.Simple type, double unitMillis) {
        Optional<Double> number = number(value);
        Optional<String> text = constant(value);
        return switch (type) {
            case BOOLEAN -> flag(value);
            case INTEGER -> number.filter(n -> n == Math.rint(n)).map(n -> new IntegerValue(n.longValue()));
            case REAL -> number.map(RealValue::new);
            case TEXT -> text.or(() -> name(value)).map(TextValue::new);
            case DURATION -> number.filter(n -> n >= 0).map(n -> new DurationValue(Math.round(n * unitMillis)));
            case PROXY -> name(value).or(() -> text).map(ProxyValue::new);
            case POINT -> point(value).map(p -> p);
            case PATH -> points(value).map(GeoPath::new);
            case AREA -> points(value).map(p -> new GeoArea(p, List.of()));
            case VARIABLE -> variable(value).map(VariableReference::new);
            case PLAN -> copies.running(value.node().path("plan").asText("")).map(PlanReference::new);
            case ANY -> natural(value, unitMillis);
            case TASK -> Optional.empty();
        };
    }

    private static Optional<Value> flag(LegacyValue value) {
        JsonNode node = value.node().isBoolean() ? value.node() : value.node().path("value");
        return node.isBoolean() ? Optional.of(new BooleanValue(node.booleanValue())) : Optional.empty();
    }

    private static Optional<Double> number(LegacyValue value) {
        JsonNode node = value.node().isNumber() ? value.node() : value.node().path("value");
        return node.isNumber() && Double.isFinite(node.doubleValue())
                ? Optional.of(node.doubleValue())
                : Optional.empty();
    }

    private static Optional<String> name(LegacyValue value) {
        for (String member : List.of("name", "value")) {
            JsonNode node = value.node().path(member);
            if (node.isTextual() && !node.textValue().isBlank()) {
                return Optional.of(node.textValue());
            }
        }
        return Optional.empty();
    }

    private static Optional<String> variable(LegacyValue value) {
        return name(value).filter(n -> !n.equals("@")).map(n -> n.startsWith("@") ? n : "@" + n);
    }

    private static Optional<GeoPoint> point(LegacyValue value) {
        JsonNode node = value.node();
        if (!node.path("lat").isNumber() || !node.path("lon").isNumber()) {
            return Optional.empty();
        }
        return Optional.of(new GeoPoint(
                node.path("lat").doubleValue(),
                node.path("lon").doubleValue(),
                node.path("alt").asDouble(0)));
    }

    private static Optional<List<LegacyValue>> items(LegacyValue value) {
        for (String member : List.of("items", "points")) {
            LegacyValue list = value.member(member);
            if (list.node().isArray()) {
                List<LegacyValue> items = new ArrayList<>();
                list.node().forEach(n -> items.add(new LegacyValue(list.pointer() + "/" + items.size(), n)));
                return Optional.of(items);
            }
        }
        return Optional.empty();
    }

    /** The points of a path, an area or a list; all of them or none. */
    private static Optional<List<GeoPoint>> points(LegacyValue value) {
        Optional<List<LegacyValue>> items = items(value);
        if (items.isEmpty()) {
            return Optional.empty();
        }
        List<GeoPoint> points = new ArrayList<>();
        for (LegacyValue item : items.get()) {
            Optional<GeoPoint> point = point(item);
            if (point.isEmpty()) {
                return Optional.empty();
            }
            points.add(point.get());
        }
        return Optional.of(points);
    }

    private Optional<List<Value>> all(List<LegacyValue> items, ValueType type, double unitMillis, int depth) {
        List<Value> values = new ArrayList<>();
        for (LegacyValue item : items) {
            Optional<Value> value = of(item, type, unitMillis, depth + 1);
            if (value.isEmpty()) {
                return Optional.empty();
            }
            values.add(value.get());
        }
        return Optional.of(values);
    }

    private Optional<Value> entries(LegacyValue value, ValueType.MapOf type, double unitMillis, int depth) {
        if (!value.node().path("entries").isArray()) {
            return Optional.empty();
        }
        Map<Value, Value> entries = new LinkedHashMap<>();
        LegacyValue list = value.member("entries");
        for (JsonNode entry : list.node()) {
            Optional<Value> key =
                    of(new LegacyValue(list.pointer(), entry.path("key")), type.key(), unitMillis, depth + 1);
            Optional<Value> item =
                    of(new LegacyValue(list.pointer(), entry.path("value")), type.value(), unitMillis, depth + 1);
            if (key.isEmpty() || item.isEmpty()) {
                return Optional.empty();
            }
            entries.put(key.get(), item.get());
        }
        return Optional.of(new MapValue(entries));
    }

    private Optional<Value> named(LegacyValue value, String name, double unitMillis, int depth) {
        NamedType declared = vocabulary.types().get(name);
        if (declared instanceof NamedType.Enumeration) {
            return constant(value).map(c -> new EnumValue(name, c));
        }
        if (!(declared instanceof NamedType.RecordType type)) {
            return Optional.empty();
        }
        Map<String, String> members = table.records().getOrDefault(LegacyPlan.simpleName(value.className()), Map.of());
        Map<String, Value> fields = new LinkedHashMap<>();
        for (Map.Entry<String, ValueType> field : type.fields().entrySet()) {
            String member = members.getOrDefault(field.getKey(), field.getKey());
            LegacyValue part = value.node().has(member)
                    ? value.member(member)
                    : value.member("fields").member(member);
            Optional<Value> converted = of(part, field.getValue(), unitMillis, depth + 1);
            if (converted.isEmpty()) {
                return Optional.empty();
            }
            fields.put(field.getKey(), converted.get());
        }
        return Optional.of(new RecordValue(name, fields));
    }

    /** What a value is by itself. */
    private Optional<Value> natural(LegacyValue value, double unitMillis) {
        return naturalType(value).flatMap(type -> of(value, type, unitMillis, 1));
    }

    /** The type that fits a value best, where nothing says what it is for. */
    Optional<ValueType> naturalType(LegacyValue value) {
        Optional<ValueType> declared = LegacyTable.find(table.types(), value.className());
        if (declared.isPresent()) {
            return declared;
        }
        return switch (value.type()) {
            case "string", "color", "enum" -> Optional.of(ValueType.Simple.TEXT);
            case "int", "long" -> Optional.of(ValueType.Simple.INTEGER);
            case "double" -> Optional.of(ValueType.Simple.REAL);
            case "bool" -> Optional.of(ValueType.Simple.BOOLEAN);
            case "location", "latlon" -> Optional.of(ValueType.Simple.POINT);
            case "path" -> Optional.of(ValueType.Simple.PATH);
            case "area" -> Optional.of(ValueType.Simple.AREA);
            case "variable-name" -> Optional.of(ValueType.Simple.VARIABLE);
            case "plan-ref" -> Optional.of(ValueType.Simple.PLAN);
            case "list" ->
                items(value)
                        .filter(items -> !items.isEmpty())
                        .flatMap(items -> naturalType(items.get(0)))
                        .map(ValueType.ListOf::new);
            default -> Optional.empty();
        };
    }
}
