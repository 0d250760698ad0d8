package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/** An edge from a place to a transition. Without requirements it is an error to the checker (thesis 4.3.3). */
public record InEdge(String id, String place, String transition, Mode mode, List<InRequirement> requirements) {
    public InEdge {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(transition, "transition");
        Objects.requireNonNull(mode, "mode");
        requirements = List.copyOf(requirements);
    }

    /** The same in edge with another id. */
    public InEdge withId(String id) {
        return new InEdge(id, place, transition, mode, requirements);
    }

    /** The same in edge with another place. */
    public InEdge withPlace(String place) {
        return new InEdge(id, place, transition, mode, requirements);
    }

    /** The same in edge with another transition. */
    public InEdge withTransition(String transition) {
        return new InEdge(id, place, transition, mode, requirements);
    }

    /** The same in edge with another mode. */
    public InEdge withMode(Mode mode) {
        return new InEdge(id, place, transition, mode, requirements);
    }

    /** The same in edge with other requirements. */
    public InEdge withRequirements(List<InRequirement> requirements) {
        return new InEdge(id, place, transition, mode, requirements);
    }
}
