package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Map;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Writes values whose type is known, in the one form that {@link ValueReader} reads back. */
final class ValueWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final Map<String, NamedType> types;

    ValueWriter(Map<String, NamedType> types) {
        this.types = types;
    }

    JsonNode write(Value value, ValueType type) {
        if (type == ValueType.Simple.ANY) {
            return TaggedValues.write(value);
        }
        if (value instanceof ListValue list && type instanceof ValueType.ListOf t) {
            ArrayNode array = NODES.arrayNode();
            list.items().forEach(item -> array.add(write(item, t.element())));
            return array;
        }
        if (value instanceof MapValue map && type instanceof ValueType.MapOf t) {
            return writeMap(map, t);
        }
        if (value instanceof RecordValue record
                && type instanceof ValueType.Named t
                && types.get(t.name()) instanceof NamedType.RecordType declared) {
            ObjectNode object = NODES.objectNode();
            declared.fields()
                    .forEach((name, fieldType) ->
                            record.field(name).ifPresent(v -> object.set(name, write(v, fieldType))));
            return object;
        }
        if (value instanceof IntegerValue whole && type == ValueType.Simple.REAL) {
            return SimpleValueWriter.number((double) whole.value());
        }
        return SimpleValueWriter.write(value);
    }

    private JsonNode writeMap(MapValue map, ValueType.MapOf type) {
        if (ValueReader.keyIsText(type.key(), types)) {
            ObjectNode object = NODES.objectNode();
            map.entries().forEach((key, v) -> object.set(write(key, type.key()).asText(), write(v, type.value())));
            return object;
        }
        ArrayNode pairs = NODES.arrayNode();
        map.entries()
                .forEach(
                        (key, v) -> pairs.addArray().add(write(key, type.key())).add(write(v, type.value())));
        return pairs;
    }
}
