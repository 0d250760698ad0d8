package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/**
 * An edge from a transition to a place. Without requirements it is an error to the checker (thesis 4.3.3).
 *
 * @param locked whether the computation of requirements leaves it as it is (thesis 5.1.1)
 */
public record OutEdge(
        String id, String transition, String place, Mode mode, List<OutRequirement> requirements, boolean locked) {
    public OutEdge {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(transition, "transition");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(mode, "mode");
        requirements = List.copyOf(requirements);
    }

    /** An out edge whose requirements may be computed. */
    public OutEdge(String id, String transition, String place, Mode mode, List<OutRequirement> requirements) {
        this(id, transition, place, mode, requirements, false);
    }

    /** The same out edge with another id. */
    public OutEdge withId(String id) {
        return new OutEdge(id, transition, place, mode, requirements, locked);
    }

    /** The same out edge with another transition. */
    public OutEdge withTransition(String transition) {
        return new OutEdge(id, transition, place, mode, requirements, locked);
    }

    /** The same out edge with another place. */
    public OutEdge withPlace(String place) {
        return new OutEdge(id, transition, place, mode, requirements, locked);
    }

    /** The same out edge with another mode. */
    public OutEdge withMode(Mode mode) {
        return new OutEdge(id, transition, place, mode, requirements, locked);
    }

    /** The same out edge with other requirements. */
    public OutEdge withRequirements(List<OutRequirement> requirements) {
        return new OutEdge(id, transition, place, mode, requirements, locked);
    }

    /** The same out edge, locked or not. */
    public OutEdge withLocked(boolean locked) {
        return new OutEdge(id, transition, place, mode, requirements, locked);
    }
}
