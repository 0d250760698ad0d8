package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/** A transition. Its in and out edges are those of the plan that name it, in the plan's order. */
public record Transition(String id, String name, Mode mode, WaitFor waitFor, List<InputEventSpec> inputs) {
    public Transition {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(waitFor, "waitFor");
        inputs = List.copyOf(inputs);
    }
}
