package org.sami.spn.stepping;

import java.util.Objects;
import org.sami.spn.model.TestStep;

/**
 * One step that can be tried at a moment.
 *
 * @param kind who does it
 */
public record NextStep(Kind kind, TestStep step) {
    /** Who does a step, those first that everybody expects. */
    public enum Kind {
        /** The operator answers. */
        DECISION,
        /** A robot or a service answers that what was asked is done. */
        ANSWER,
        /** The next timer or deadline runs down. */
        TIME,
        /** A robot or a service answers that what was asked failed. */
        FAILURE,
        /** The operator presses an interrupt. */
        INTERRUPT,
        /** Something happens that nobody asked for. */
        NEWS,
        /** The operator gives a list without any item where one is asked for. */
        EMPTY,
        /** The operator drops a robot from the mission. */
        DROP
    }

    public NextStep {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(step, "step");
    }
}
