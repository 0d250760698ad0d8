package org.sami.crw.sim.run.operator;

import org.sami.crw.session.SessionOperator.Asked;
import org.sami.spn.json.Reading;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;

/** Determines what a simulated operator answers. For the engine's thread. */
@FunctionalInterface
public interface AnswerSource {
    /**
     * The answer to a decision; asked once for each.
     *
     * @param plan id of the asking mission's plan
     * @return neither result nor finding where the operator stays silent; findings where no sensible answer exists
     */
    Reading<Answer> answer(Decision decision, String plan);

    /** How long this answer is delayed in addition to the operator's usual delay, in ms: an alarm, for instance, has a length. */
    default long furtherMillis(Asked asked) {
        return 0;
    }
}
