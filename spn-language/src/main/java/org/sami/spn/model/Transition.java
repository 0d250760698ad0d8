package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/**
 * A transition. Its in and out edges are those of the plan that name it, in the plan's order.
 *
 * @param disabled whether it never fires while the plan is tried
 */
public record Transition(
        String id, String name, Mode mode, WaitFor waitFor, List<InputEventSpec> inputs, boolean disabled) {
    public Transition {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(waitFor, "waitFor");
        inputs = List.copyOf(inputs);
    }

    /** A transition that is not disabled. */
    public Transition(String id, String name, Mode mode, WaitFor waitFor, List<InputEventSpec> inputs) {
        this(id, name, mode, waitFor, inputs, false);
    }

    /** The same transition with another id. */
    public Transition withId(String id) {
        return new Transition(id, name, mode, waitFor, inputs, disabled);
    }

    /** The same transition with another name. */
    public Transition withName(String name) {
        return new Transition(id, name, mode, waitFor, inputs, disabled);
    }

    /** The same transition with another mode. */
    public Transition withMode(Mode mode) {
        return new Transition(id, name, mode, waitFor, inputs, disabled);
    }

    /** The same transition with another rule of waiting. */
    public Transition withWaitFor(WaitFor waitFor) {
        return new Transition(id, name, mode, waitFor, inputs, disabled);
    }

    /** The same transition with other inputs. */
    public Transition withInputs(List<InputEventSpec> inputs) {
        return new Transition(id, name, mode, waitFor, inputs, disabled);
    }

    /** The same transition with another value of {@code disabled}. */
    public Transition withDisabled(boolean disabled) {
        return new Transition(id, name, mode, waitFor, inputs, disabled);
    }
}
