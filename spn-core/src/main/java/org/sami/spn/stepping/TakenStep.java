package org.sami.spn.stepping;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.protocol.Effect;

/**
 * What became of a step.
 *
 * @param number how many steps have been taken with this one; where it was refused, as many as before
 * @param effects what the engine did, in order; empty where the step was refused
 * @param refusal why it could not be taken, in one sentence; then nothing has changed
 */
public record TakenStep(int number, List<Effect> effects, Optional<String> refusal) {
    public TakenStep {
        effects = List.copyOf(effects);
        Objects.requireNonNull(refusal, "refusal");
    }
}
