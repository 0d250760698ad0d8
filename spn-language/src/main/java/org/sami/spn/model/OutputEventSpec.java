package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * An output event on a place.
 *
 * @param id unique in the plan
 * @param type name of the event type
 * @param fields source of each field that is given
 * @param writes variables ({@code @name}) that receive a field's resolved value, by field
 */
public record OutputEventSpec(
        String id, String type, Map<String, FieldSource> fields, Map<String, String> writes, List<MarkupSpec> markups) {
    public OutputEventSpec {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(type, "type");
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
        writes = Collections.unmodifiableMap(new LinkedHashMap<>(writes));
        markups = List.copyOf(markups);
    }

    /** The same output event with another id. */
    public OutputEventSpec withId(String id) {
        return new OutputEventSpec(id, type, fields, writes, markups);
    }

    /** The same output event with other fields. */
    public OutputEventSpec withFields(Map<String, FieldSource> fields) {
        return new OutputEventSpec(id, type, fields, writes, markups);
    }

    /** The same output event with other writes. */
    public OutputEventSpec withWrites(Map<String, String> writes) {
        return new OutputEventSpec(id, type, fields, writes, markups);
    }

    /** The same output event with other markups. */
    public OutputEventSpec withMarkups(List<MarkupSpec> markups) {
        return new OutputEventSpec(id, type, fields, writes, markups);
    }
}
