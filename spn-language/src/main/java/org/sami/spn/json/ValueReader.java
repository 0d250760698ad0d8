package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Reads values whose type is known; every mismatch is a problem at its place. */
final class ValueReader {
    private final Map<String, NamedType> types;
    private final Problems problems;
    private final SimpleValueReader simples;

    ValueReader(Map<String, NamedType> types, Problems problems) {
        this.types = types;
        this.problems = problems;
        this.simples = new SimpleValueReader(problems);
    }

    Optional<Value> read(JsonNode node, ValueType type, String pointer) {
        if (type instanceof ValueType.Simple simple) {
            return simple == ValueType.Simple.ANY
                    ? new TaggedValues(problems).read(node, pointer)
                    : simples.read(node, simple, pointer);
        }
        if (type instanceof ValueType.ListOf list) {
            return readList(node, list.element(), pointer);
        }
        if (type instanceof ValueType.MapOf map) {
            return readMap(node, map, pointer);
        }
        return readNamed(node, ((ValueType.Named) type).name(), pointer);
    }

    private Optional<Value> readList(JsonNode node, ValueType element, String pointer) {
        if (!node.isArray()) {
            return simples.wrong(node, "a list", pointer);
        }
        List<Value> items = new ArrayList<>();
        for (int i = 0; i < node.size(); i++) {
            read(node.get(i), element, Problems.at(pointer, i)).ifPresent(items::add);
        }
        return items.size() == node.size() ? Optional.of(new ListValue(items)) : Optional.empty();
    }

    private Optional<Value> readMap(JsonNode node, ValueType.MapOf type, String pointer) {
        return keyIsText(type.key(), types) ? readObjectMap(node, type, pointer) : readPairs(node, type, pointer);
    }

    /** Whether a map's keys are written as the members' names of an object; else the map is a list of pairs. */
    static boolean keyIsText(ValueType key, Map<String, NamedType> types) {
        return key == ValueType.Simple.TEXT
                || key == ValueType.Simple.PROXY
                || key == ValueType.Simple.PLAN
                || key == ValueType.Simple.VARIABLE
                || (key instanceof ValueType.Named named && types.get(named.name()) instanceof NamedType.Enumeration);
    }

    private Optional<Value> readObjectMap(JsonNode node, ValueType.MapOf type, String pointer) {
        if (!node.isObject()) {
            return simples.wrong(node, "an object", pointer);
        }
        Map<Value, Value> entries = new LinkedHashMap<>();
        for (Map.Entry<String, JsonNode> e : node.properties()) {
            String where = Problems.at(pointer, e.getKey());
            Optional<Value> key = read(TextNode.valueOf(e.getKey()), type.key(), where);
            Optional<Value> value = read(e.getValue(), type.value(), where);
            if (key.isPresent() && value.isPresent()) {
                entries.put(key.get(), value.get());
            }
        }
        return entries.size() == node.size() ? Optional.of(new MapValue(entries)) : Optional.empty();
    }

    private Optional<Value> readPairs(JsonNode node, ValueType.MapOf type, String pointer) {
        if (!node.isArray()) {
            return simples.wrong(node, "a list of pairs [key, value]", pointer);
        }
        Map<Value, Value> entries = new LinkedHashMap<>();
        for (int i = 0; i < node.size(); i++) {
            JsonNode pair = node.get(i);
            String where = Problems.at(pointer, i);
            if (!pair.isArray() || pair.size() != 2) {
                return simples.wrong(pair, "a pair [key, value]", where);
            }
            Optional<Value> key = read(pair.get(0), type.key(), where + "/0");
            Optional<Value> value = read(pair.get(1), type.value(), where + "/1");
            if (key.isPresent() && value.isPresent() && entries.put(key.get(), value.get()) != null) {
                problems.add(Codes.DUPLICATE, where, "This key stands in the map twice");
            }
        }
        return entries.size() == node.size() ? Optional.of(new MapValue(entries)) : Optional.empty();
    }

    private Optional<Value> readNamed(JsonNode node, String name, String pointer) {
        NamedType declared = types.get(name);
        if (declared instanceof NamedType.Enumeration enumeration) {
            return simples.text(node, "a constant of " + name, pointer).flatMap(t -> constant(t, enumeration, pointer));
        }
        if (declared instanceof NamedType.RecordType record) {
            return readRecord(node, record, pointer);
        }
        problems.add(Codes.UNKNOWN_TYPE, pointer, "The type " + name + " is not declared");
        return Optional.empty();
    }

    private Optional<Value> constant(String text, NamedType.Enumeration type, String pointer) {
        if (type.constants().contains(text)) {
            return Optional.of(new EnumValue(type.name(), text));
        }
        problems.add(
                Codes.UNKNOWN_WORD,
                pointer,
                "\"" + text + "\" is no " + type.name() + "; those are " + String.join(", ", type.constants()));
        return Optional.empty();
    }

    private Optional<Value> readRecord(JsonNode node, NamedType.RecordType type, String pointer) {
        Optional<JsonObjectReader> members = JsonObjectReader.of(node, pointer, problems);
        if (members.isEmpty()) {
            return Optional.empty();
        }
        Map<String, Value> fields = new LinkedHashMap<>();
        type.fields().forEach((name, fieldType) -> {
            Optional<JsonNode> field = members.get().node(name);
            if (field.isEmpty()) {
                problems.add(Codes.MISSING, pointer, "The field \"" + name + "\" of " + type.name() + " is missing");
            }
            field.flatMap(f -> read(f, fieldType, Problems.at(pointer, name))).ifPresent(v -> fields.put(name, v));
        });
        members.get().done();
        return fields.size() == type.fields().size()
                ? Optional.of(new RecordValue(type.name(), fields))
                : Optional.empty();
    }
}
