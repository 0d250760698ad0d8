package org.sami.crw.session;

import java.util.Optional;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;

/**
 * Somebody who answers decisions: a window, the simulated operator, an answers file. A session may have several at once: all are
 * asked, the first answer counts, and all learn it. Called on the engine's thread, must be quick; answers go to
 * {@link Session#answer(long, Answer, String)}, now or later, from any thread.
 */
public interface SessionOperator {
    /** Names it to the others, such as {@code window}. */
    String name();

    /** A decision waits. */
    void asked(Asked asked);

    /**
     * A decision waits no longer.
     *
     * @param answer empty if nobody answered: its mission or its visit ended
     * @param by name of the operator who answered first, or {@code autonomy}; empty text without an answer
     */
    void settled(long decision, Optional<Answer> answer, String by);

    /**
     * A waiting decision.
     *
     * @param presentation the decision for display
     * @param plan id of the mission's plan; empty text where the domain asks
     * @param workMillis how long the asked work keeps the operator busy, without answering (thesis 8.1)
     * @param atMillis when it was asked, in the session's time
     */
    record Asked(DecisionPresentation presentation, String plan, long workMillis, long atMillis) {
        /** The decision, with its question as it is asked. */
        public Decision decision() {
            return presentation.decision();
        }
    }
}
