package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/**
 * An edge from a place to a transition. Without requirements it is an error to the checker (thesis 4.3.3).
 *
 * @param locked whether the computation of requirements leaves it as it is (thesis 5.1.1)
 */
public record InEdge(
        String id, String place, String transition, Mode mode, List<InRequirement> requirements, boolean locked) {
    public InEdge {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(transition, "transition");
        Objects.requireNonNull(mode, "mode");
        requirements = List.copyOf(requirements);
    }

    /** An in edge whose requirements may be computed. */
    public InEdge(String id, String place, String transition, Mode mode, List<InRequirement> requirements) {
        this(id, place, transition, mode, requirements, false);
    }

    /** The same in edge with another id. */
    public InEdge withId(String id) {
        return new InEdge(id, place, transition, mode, requirements, locked);
    }

    /** The same in edge with another place. */
    public InEdge withPlace(String place) {
        return new InEdge(id, place, transition, mode, requirements, locked);
    }

    /** The same in edge with another transition. */
    public InEdge withTransition(String transition) {
        return new InEdge(id, place, transition, mode, requirements, locked);
    }

    /** The same in edge with another mode. */
    public InEdge withMode(Mode mode) {
        return new InEdge(id, place, transition, mode, requirements, locked);
    }

    /** The same in edge with other requirements. */
    public InEdge withRequirements(List<InRequirement> requirements) {
        return new InEdge(id, place, transition, mode, requirements, locked);
    }

    /** The same in edge, locked or not. */
    public InEdge withLocked(boolean locked) {
        return new InEdge(id, place, transition, mode, requirements, locked);
    }
}
