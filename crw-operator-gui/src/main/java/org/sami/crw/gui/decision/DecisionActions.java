package org.sami.crw.gui.decision;

import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;

/** What the panel has done with decisions. Returns at once; what comes of it arrives on the event thread. */
interface DecisionActions {
    /** Answers a decision; fails with one sentence where the answer is refused. */
    CompletionStage<Void> answer(long decision, Answer answer);

    /** Says why an answer would be refused now; empty where it would not. */
    Optional<String> check(long decision, Answer answer);

    /** Why nothing can be answered here, as in a replay; empty where it can. */
    Optional<String> whyNotAct();

    /** The judgement of the answer as it is filled in. */
    CompletionStage<Judgement> judge(Decision decision, DraftAnswer draft);

    /** The operator has turned to a decision: no attention is drawn to it any longer. */
    void attend(long decision);

    /** Stops the timer after which autonomy answers. */
    CompletionStage<Void> hold(long decision);

    /** The session's clock. */
    long nowMillis();
}
