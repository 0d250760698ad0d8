package org.sami.spn.value;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** A record of a type that the vocabulary declares: named fields in the order of their declaration. */
public record RecordValue(String type, Map<String, Value> fields) implements Value {
    public RecordValue {
        Objects.requireNonNull(type, "type");
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
    }

    /** The value of a field, empty where the record has none of that name. */
    public Optional<Value> field(String name) {
        return Optional.ofNullable(fields.get(name));
    }
}
