package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.Value;

/** One markup on an event, with its options (thesis 3.1, Markup). */
public record MarkupSpec(String type, Map<String, Value> options) {
    public MarkupSpec {
        Objects.requireNonNull(type, "type");
        options = Collections.unmodifiableMap(new LinkedHashMap<>(options));
    }

    /** The value of an option, empty where it is not set. */
    public Optional<Value> option(String name) {
        return Optional.ofNullable(options.get(name));
    }
}
