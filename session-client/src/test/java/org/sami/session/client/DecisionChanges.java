package org.sami.session.client;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.crw.operator.decision.DecisionListener;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;

/** Which decisions were opened and closed, as lines in their order. Safe for use by several threads. */
final class DecisionChanges implements DecisionListener {
    private final List<String> lines = new CopyOnWriteArrayList<>();

    /** What has happened so far, such as {@code opened 3}. */
    List<String> lines() {
        return List.copyOf(lines);
    }

    @Override
    public void opened(PendingDecision decision) {
        lines.add("opened " + decision.decision().id());
    }

    @Override
    public void closed(PendingDecision decision, Optional<Answer> answer, Optional<Answerer> by) {
        lines.add("closed " + decision.decision().id());
    }
}
