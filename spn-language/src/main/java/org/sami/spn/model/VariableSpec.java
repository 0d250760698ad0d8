package org.sami.spn.model;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * A variable that a plan or the project declares.
 *
 * @param name with its leading {@code @}
 * @param initial its value before anything is written
 */
public record VariableSpec(String name, ValueType type, Optional<Value> initial) {
    public VariableSpec {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(initial, "initial");
        if (!name.startsWith("@") || name.length() == 1) {
            throw new IllegalArgumentException("A variable's name begins with @ and goes on: " + name);
        }
        if (name.equals("@task")) {
            throw new IllegalArgumentException("@task is reserved (thesis 9.3.4)");
        }
    }

    /** The same variable with another name. */
    public VariableSpec withName(String name) {
        return new VariableSpec(name, type, initial);
    }

    /** The same variable with another first value. */
    public VariableSpec withInitial(Optional<Value> initial) {
        return new VariableSpec(name, type, initial);
    }
}
