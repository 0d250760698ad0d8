package org.sami.spn.value;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** The declaration of a named type in the vocabulary. */
public sealed interface NamedType {
    /** The name by which {@link ValueType.Named} refers to it. */
    String name();

    /** An enumeration with its constants in order. */
    record Enumeration(String name, List<String> constants) implements NamedType {
        public Enumeration {
            Objects.requireNonNull(name, "name");
            constants = List.copyOf(constants);
        }
    }

    /** A record with its fields in order; every field must be present in a value. */
    record RecordType(String name, Map<String, ValueType> fields) implements NamedType {
        public RecordType {
            Objects.requireNonNull(name, "name");
            fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
        }
    }
}
