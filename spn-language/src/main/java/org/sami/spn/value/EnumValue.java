package org.sami.spn.value;

import java.util.Objects;

/** One constant of an enumeration that the vocabulary declares. */
public record EnumValue(String type, String constant) implements Value {
    public EnumValue {
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(constant, "constant");
    }
}
