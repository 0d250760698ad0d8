package org.sami.spn.engine;

import java.util.Optional;
import org.sami.spn.engine.rule.AnswerCheck;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Question;
import org.sami.spn.vocabulary.AnswerNames;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Tells beforehand whether the engine would take an answer, so that a form can say why not while it is filled in. The same check that
 * the engine makes of answers that arrive.
 */
public final class DecisionCheck {
    private DecisionCheck() {}

    /** Says why an answer does not fit a decision that is open, in one sentence; empty where it fits. */
    public static Optional<String> wrong(Decision decision, Answer answer, Vocabulary vocabulary) {
        Optional<DecisionType> type = decision.activation() == Ids.NONE
                ? Optional.empty()
                : vocabulary.event(decision.type()).flatMap(EventType::decision);
        if (type.filter(asks -> asks.names() == AnswerNames.CHOSEN).isPresent()
                && answer instanceof Answer.Proxies chosen
                && chosen.proxies().isEmpty()) {
            return Optional.of("nobody is chosen");
        }
        boolean mayReject = decision.question() instanceof Question.ChooseProxies
                ? decision.isInterruptChoice()
                : type.filter(asks -> !asks.rejected().isEmpty()).isPresent();
        return AnswerCheck.wrong(decision.question(), answer, mayReject, vocabulary);
    }
}
