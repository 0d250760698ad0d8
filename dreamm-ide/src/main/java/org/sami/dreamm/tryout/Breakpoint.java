package org.sami.dreamm.tryout;

import java.util.Objects;

/** A vertex of a plan at which a run stops. */
public record Breakpoint(String plan, String vertex) {
    public Breakpoint {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(vertex, "vertex");
    }
}
