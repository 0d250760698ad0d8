package org.sami.crw.operator.decision;

import java.util.Optional;
import org.sami.crw.operator.DecisionQueue;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;

/** Receives the changes of a {@link DecisionQueue}, each after it was made, on the thread that owns the queue. */
public interface DecisionListener {
    /** A decision waits. */
    void opened(PendingDecision decision);

    /** A decision waits no longer; without an answer, its visit or mission ended. */
    void closed(PendingDecision decision, Optional<Answer> answer, Optional<Answerer> by);

    /** The operator has stopped the timer of a decision: autonomy does not answer it any longer. */
    default void held(PendingDecision decision) {}
}
