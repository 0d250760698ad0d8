package org.sami.crw.gui.decision;

import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.protocol.Priority;

/**
 * A decision that waits, in one line.
 *
 * @param question the question, with the boats where it is about few; urgent ones with a mark before it
 * @param mission who asks: mission and plan
 * @param age how long it has waited
 * @param left how long autonomy leaves to the operator
 */
record WaitingRow(long decision, Priority priority, String question, String mission, String age, String left) {
    static WaitingRow of(PendingDecision pending, long nowMillis) {
        DecisionPresentation shown = pending.presentation();
        String boats = DecisionWords.boats(shown);
        Priority priority = pending.decision().priority();
        return new WaitingRow(
                pending.decision().id(),
                priority,
                DecisionWords.mark(priority) + (boats.isEmpty() ? "" : boats + ": ") + DecisionWords.heading(shown),
                DecisionWords.mission(shown),
                DecisionWords.brief(pending.ageMillis(nowMillis)),
                DecisionWords.left(pending, nowMillis));
    }
}
