package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * Values as JSON, in two forms: one for files, read by the type that is expected, and one that says its own type, for
 * journals and reports. Both give back what they were given; in the first, a whole number in a field of type real is that
 * real number. docs/file-format.md shows them.
 */
public final class ValueJson {
    private ValueJson() {}

    /**
     * The form for files.
     *
     * @param type a type that accepts the value
     * @param types the named types of the vocabulary
     */
    public static JsonNode write(Value value, ValueType type, Map<String, NamedType> types) {
        return new ValueWriter(types).write(value, type);
    }

    /** Reads the form for files; pointers of findings are relative to the node. */
    public static Reading<Value> read(JsonNode node, ValueType type, Map<String, NamedType> types) {
        Problems problems = new Problems();
        return reading(new ValueReader(types, problems).read(node, type, ""), problems);
    }

    /** Reads the form for files from text, such as {@code "PT10S"} with its quotation marks. */
    public static Reading<Value> read(String text, ValueType type, Map<String, NamedType> types) {
        Problems problems = new Problems();
        Optional<JsonNode> node = JsonText.parse(text, problems);
        return reading(node.flatMap(n -> new ValueReader(types, problems).read(n, type, "")), problems);
    }

    /** The form that says its own type. */
    public static JsonNode tagged(Value value) {
        return TaggedValues.write(value);
    }

    /** Reads the form that says its own type; names of types are not looked up. */
    public static Reading<Value> fromTagged(JsonNode node) {
        Problems problems = new Problems();
        return reading(new TaggedValues(problems).read(node, ""), problems);
    }

    private static Reading<Value> reading(Optional<Value> value, Problems problems) {
        return new Reading<>(problems.none() ? value : Optional.empty(), problems.findings());
    }
}
