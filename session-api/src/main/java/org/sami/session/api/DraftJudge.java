package org.sami.session.api;

import java.util.Map;
import java.util.concurrent.CompletionStage;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.Value;

/** Judges drafts of answers, and values before they are set, by the present state of engine and boats. From any thread. */
public interface DraftJudge {
    /** Judges a draft of an answer: what of it cannot be, what boats are not to enter, and what it takes. */
    CompletionStage<Judgement> judge(Decision decision, DraftAnswer draft);

    /**
     * Judges values with which a mission of a plan is to start, as answers are.
     *
     * @param values by the names of parameters
     */
    CompletionStage<Judgement> judgeStart(String plan, Map<String, Value> values);

    /** Judges a value that a global is to have: what of it cannot be, and where boats are not to enter. */
    CompletionStage<Judgement> judgeGlobal(String name, Value value);
}
