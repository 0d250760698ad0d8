package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.Value;

/**
 * An input event on a transition.
 *
 * @param id unique in the plan
 * @param type name of the event type
 * @param fields fixed values by which roles select, such as {@code interruptName} and {@code value} of Check Return
 * @param writes variables ({@code @name}) that receive a field's value when the transition fires, by field
 */
public record InputEventSpec(
        String id, String type, Map<String, Value> fields, Map<String, String> writes, List<MarkupSpec> markups) {
    public InputEventSpec {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(type, "type");
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
        writes = Collections.unmodifiableMap(new LinkedHashMap<>(writes));
        markups = List.copyOf(markups);
    }

    /** The same input event with another id. */
    public InputEventSpec withId(String id) {
        return new InputEventSpec(id, type, fields, writes, markups);
    }

    /** The same input event with other fields. */
    public InputEventSpec withFields(Map<String, Value> fields) {
        return new InputEventSpec(id, type, fields, writes, markups);
    }

    /** The same input event with other writes. */
    public InputEventSpec withWrites(Map<String, String> writes) {
        return new InputEventSpec(id, type, fields, writes, markups);
    }

    /** The same input event with other markups. */
    public InputEventSpec withMarkups(List<MarkupSpec> markups) {
        return new InputEventSpec(id, type, fields, writes, markups);
    }
}
