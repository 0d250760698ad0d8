package org.sami.spn.value;

import java.util.Objects;

/** The id of a plan as a value. */
public record PlanReference(String plan) implements Value {
    public PlanReference {
        Objects.requireNonNull(plan, "plan");
    }
}
