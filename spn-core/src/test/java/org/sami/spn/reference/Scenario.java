package org.sami.spn.reference;

import java.util.List;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Input;

/** A project and what happens to it. */
record Scenario(long seed, Project project, List<Timed> inputs) {
    /** Short, so that random rings end soon. */
    static final int LIVELOCK_LIMIT = 25;

    /** Inputs of a session, unless it is to be a long one. */
    static final int LENGTH = 50;

    /** An input with the session's time. */
    record Timed(long nowMillis, Input input) {}

    Scenario {
        inputs = List.copyOf(inputs);
    }

    Scenario with(Project otherProject) {
        return new Scenario(seed, otherProject, inputs);
    }

    Scenario with(List<Timed> otherInputs) {
        return new Scenario(seed, project, otherInputs);
    }
}
