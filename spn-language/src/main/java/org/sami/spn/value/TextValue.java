package org.sami.spn.value;

import java.util.Objects;

/** A piece of text. */
public record TextValue(String value) implements Value {
    public TextValue {
        Objects.requireNonNull(value, "value");
    }
}
