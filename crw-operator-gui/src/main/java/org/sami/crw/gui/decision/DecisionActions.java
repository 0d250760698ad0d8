package org.sami.crw.gui.decision;

import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.sami.spn.protocol.Answer;

/** What the panel has done with decisions. Returns at once; what comes of it arrives on the event thread. */
interface DecisionActions {
    /** Answers a decision; fails with one sentence where the answer is refused. */
    CompletionStage<Void> answer(long decision, Answer answer);

    /** Says why an answer would be refused now; empty where it would not. */
    Optional<String> check(long decision, Answer answer);

    /** The operator has turned to a decision: no attention is drawn to it any longer. */
    void attend(long decision);

    /** Stops the timer after which autonomy answers. */
    CompletionStage<Void> hold(long decision);

    /** The session's clock. */
    long nowMillis();
}
