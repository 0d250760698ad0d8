package org.sami.spn.value;

import java.util.Objects;

/** The name of a variable as a value, with its leading {@code @} (Redefine Variables, Select Variable). */
public record VariableReference(String variable) implements Value {
    public VariableReference {
        Objects.requireNonNull(variable, "variable");
    }
}
