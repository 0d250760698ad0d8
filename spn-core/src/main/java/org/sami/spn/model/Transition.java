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

    /** The same transition with another id. */
    public Transition withId(String id) {
        return new Transition(id, name, mode, waitFor, inputs);
    }

    /** The same transition with another name. */
    public Transition withName(String name) {
        return new Transition(id, name, mode, waitFor, inputs);
    }

    /** The same transition with another mode. */
    public Transition withMode(Mode mode) {
        return new Transition(id, name, mode, waitFor, inputs);
    }

    /** The same transition with another rule of waiting. */
    public Transition withWaitFor(WaitFor waitFor) {
        return new Transition(id, name, mode, waitFor, inputs);
    }

    /** The same transition with other inputs. */
    public Transition withInputs(List<InputEventSpec> inputs) {
        return new Transition(id, name, mode, waitFor, inputs);
    }
}
