package org.sami.spn.value;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** A map from values of one type to values of another, in order of insertion; equality ignores the order. */
public record MapValue(Map<Value, Value> entries) implements Value {
    public MapValue {
        entries = Collections.unmodifiableMap(new LinkedHashMap<>(entries));
    }

    /** The value under a key, empty where there is none. */
    public Optional<Value> get(Value key) {
        return Optional.ofNullable(entries.get(key));
    }
}
