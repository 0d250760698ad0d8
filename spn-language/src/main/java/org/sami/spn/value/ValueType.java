package org.sami.spn.value;

import java.util.Objects;

/** The type of a value. Enumerations and records are named; their declarations stand in the vocabulary. */
public sealed interface ValueType {

    /** Types without parameters. */
    enum Simple implements ValueType {
        BOOLEAN,
        INTEGER,
        REAL,
        TEXT,
        DURATION,
        /** A robot's proxy. */
        PROXY,
        TASK,
        POINT,
        PATH,
        AREA,
        VARIABLE,
        PLAN,
        /** Any value at all. */
        ANY
    }

    /** A named enumeration or record of the vocabulary. */
    record Named(String name) implements ValueType {
        public Named {
            Objects.requireNonNull(name, "name");
        }
    }

    /** A list. */
    record ListOf(ValueType element) implements ValueType {
        public ListOf {
            Objects.requireNonNull(element, "element");
        }
    }

    /** A map. */
    record MapOf(ValueType key, ValueType value) implements ValueType {
        public MapOf {
            Objects.requireNonNull(key, "key");
            Objects.requireNonNull(value, "value");
        }
    }
}
