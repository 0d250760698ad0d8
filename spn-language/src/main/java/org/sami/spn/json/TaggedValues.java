package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * Values that say their own type: an object with one member, the type's word, such as {@code {"point": {...}}}. An
 * enumeration is {@code {"enum": [type, constant]}}, a record {@code {"record": [type, {field: value}]}}, a map a list of
 * pairs.
 */
final class TaggedValues {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final Problems problems;

    TaggedValues(Problems problems) {
        this.problems = problems;
    }

    static JsonNode write(Value value) {
        ObjectNode tagged = NODES.objectNode();
        if (value instanceof EnumValue v) {
            tagged.putArray("enum").add(v.type()).add(v.constant());
        } else if (value instanceof RecordValue v) {
            ObjectNode fields = NODES.objectNode();
            v.fields().forEach((name, field) -> fields.set(name, write(field)));
            tagged.putArray("record").add(v.type()).add(fields);
        } else if (value instanceof ListValue v) {
            ArrayNode items = tagged.putArray("list");
            v.items().forEach(item -> items.add(write(item)));
        } else if (value instanceof MapValue v) {
            ArrayNode pairs = tagged.putArray("map");
            v.entries().forEach((key, e) -> pairs.addArray().add(write(key)).add(write(e)));
        } else {
            tagged.set(tag(value), SimpleValueWriter.write(value));
        }
        return tagged;
    }

    private static String tag(Value value) {
        if (value instanceof BooleanValue) {
            return "boolean";
        } else if (value instanceof IntegerValue) {
            return "integer";
        } else if (value instanceof RealValue) {
            return "real";
        } else if (value instanceof TextValue) {
            return "text";
        } else if (value instanceof DurationValue) {
            return "duration";
        } else if (value instanceof ProxyValue) {
            return "proxy";
        } else if (value instanceof TaskId) {
            return "task";
        } else if (value instanceof GeoPoint) {
            return "point";
        } else if (value instanceof GeoPath) {
            return "path";
        } else if (value instanceof GeoArea) {
            return "area";
        } else if (value instanceof PlanReference) {
            return "plan";
        }
        return "variable";
    }

    Optional<Value> read(JsonNode node, String pointer) {
        if (!node.isObject() || node.size() != 1) {
            return wrong(node, "an object with one member, the type of the value", pointer);
        }
        Map.Entry<String, JsonNode> only = node.properties().iterator().next();
        String where = Problems.at(pointer, only.getKey());
        return switch (only.getKey()) {
            case "enum" -> readEnum(only.getValue(), where);
            case "record" -> readRecord(only.getValue(), where);
            case "list" -> readList(only.getValue(), where);
            case "map" -> readMap(only.getValue(), where);
            default -> readLeaf(only.getKey(), only.getValue(), where);
        };
    }

    private Optional<Value> readEnum(JsonNode node, String pointer) {
        return node.isArray()
                        && node.size() == 2
                        && node.get(0).isTextual()
                        && node.get(1).isTextual()
                ? Optional.of(new EnumValue(node.get(0).textValue(), node.get(1).textValue()))
                : wrong(node, "[type, constant]", pointer);
    }

    private Optional<Value> readRecord(JsonNode node, String pointer) {
        if (!node.isArray()
                || node.size() != 2
                || !node.get(0).isTextual()
                || !node.get(1).isObject()) {
            return wrong(node, "[type, {field: value}]", pointer);
        }
        Map<String, Value> fields = new LinkedHashMap<>();
        for (Map.Entry<String, JsonNode> e : node.get(1).properties()) {
            read(e.getValue(), Problems.at(pointer + "/1", e.getKey())).ifPresent(v -> fields.put(e.getKey(), v));
        }
        return fields.size() == node.get(1).size()
                ? Optional.of(new RecordValue(node.get(0).textValue(), fields))
                : Optional.empty();
    }

    private Optional<Value> readList(JsonNode node, String pointer) {
        if (!node.isArray()) {
            return wrong(node, "a list", pointer);
        }
        List<Value> items = new ArrayList<>();
        for (int i = 0; i < node.size(); i++) {
            read(node.get(i), Problems.at(pointer, i)).ifPresent(items::add);
        }
        return items.size() == node.size() ? Optional.of(new ListValue(items)) : Optional.empty();
    }

    private Optional<Value> readMap(JsonNode node, String pointer) {
        if (!node.isArray()) {
            return wrong(node, "a list of pairs [key, value]", pointer);
        }
        Map<Value, Value> entries = new LinkedHashMap<>();
        for (int i = 0; i < node.size(); i++) {
            JsonNode pair = node.get(i);
            String where = Problems.at(pointer, i);
            if (!pair.isArray() || pair.size() != 2) {
                return wrong(pair, "a pair [key, value]", where);
            }
            Optional<Value> key = read(pair.get(0), where + "/0");
            Optional<Value> value = read(pair.get(1), where + "/1");
            if (key.isPresent() && value.isPresent()) {
                entries.put(key.get(), value.get());
            }
        }
        return entries.size() == node.size() ? Optional.of(new MapValue(entries)) : Optional.empty();
    }

    private Optional<Value> readLeaf(String tag, JsonNode node, String pointer) {
        Optional<ValueType> type = TypeNames.parse(tag);
        if (type.isEmpty() || !(type.get() instanceof ValueType.Simple simple) || simple == ValueType.Simple.ANY) {
            problems.add(Codes.UNKNOWN_TYPE, pointer, "\"" + tag + "\" is no type of a value");
            return Optional.empty();
        }
        return new SimpleValueReader(problems).read(node, simple, pointer);
    }

    private Optional<Value> wrong(JsonNode node, String expected, String pointer) {
        problems.add(
                Codes.WRONG_TYPE,
                pointer,
                "Expected is " + expected + ", found was " + JsonObjectReader.describe(node));
        return Optional.empty();
    }
}
