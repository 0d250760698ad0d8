package org.sami.spn.statespace;

import java.util.List;
import org.sami.spn.protocol.Effect;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.Stepper;

/** Sees every step that a search takes. */
interface StepObserver {
    /**
     * A step was taken.
     *
     * @param from the state before it
     * @param before the stepper as it was there
     * @param after another, behind the step
     */
    void took(Node from, NextStep step, Stepper before, Stepper after, List<Effect> effects);
}
