package org.sami.spn.component;

import java.util.Objects;
import java.util.Optional;

/**
 * How a component did in the search for a direct one.
 *
 * @param direct how it would be used; empty where it cannot handle the type
 */
public record Candidate(ComponentType component, Optional<ChosenComponent.Direct> direct) {
    public Candidate {
        Objects.requireNonNull(component, "component");
        Objects.requireNonNull(direct, "direct");
    }
}
