package org.sami.crw.sim.run.incident;

import java.util.Objects;

/**
 * What a run's operator does besides its missions: actions of a plan, one at a time in the order in which they are asked for (thesis 8.1, Figure 8.2b).
 * Incidents are noticed only during those of one place.
 *
 * @param plan its id; empty text where the operator does nothing else and notices incidents at once
 * @param noticing id of the place
 */
public record BackgroundActions(String plan, String noticing) {
    /** Nothing else is done. */
    public static final BackgroundActions NONE = new BackgroundActions("", "");

    public BackgroundActions {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(noticing, "noticing");
    }

    boolean areNone() {
        return plan.isEmpty();
    }
}
