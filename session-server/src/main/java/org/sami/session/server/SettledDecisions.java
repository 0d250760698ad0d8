package org.sami.session.server;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.session.SessionOperator;
import org.sami.spn.protocol.Answer;

/** Remembers who answered the latest decisions, for whoever answers second. From any thread. */
final class SettledDecisions implements SessionOperator {
    private static final int KEPT = 500;

    private final Map<Long, String> settled = new LinkedHashMap<>();

    @Override
    public String name() {
        return "session server";
    }

    @Override
    public void asked(Asked asked) {
        // the models show it
    }

    @Override
    public synchronized void settled(long decision, Optional<Answer> answer, String by) {
        if (settled.size() >= KEPT) {
            settled.remove(settled.keySet().iterator().next());
        }
        settled.put(
                decision,
                answer.map(given -> by + " has answered decision " + decision + " already: " + EngineText.answer(given))
                        .orElse("Decision " + decision + " waits no longer: nobody answered it"));
    }

    /** What became of a decision that does not wait, in one sentence. */
    synchronized String words(long decision) {
        return settled.getOrDefault(decision, "No decision " + decision + " waits");
    }
}
