package org.sami.crw.gui.map;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.spn.protocol.Question;

/**
 * The boats that stand out on the map while a decision is shown, and all else is dimmed. None where values are filled in: who draws an area needs to
 * see what is there.
 */
final class BoatsOfDecision {
    private BoatsOfDecision() {}

    /**
     * Whom it is about. Of all that an activation sends a question about ways is about some: those whose paths are known; in a replay, which has
     * no paths, those that the question names.
     */
    static Set<String> of(DecisionPresentation decision, Optional<DoubtedPaths> doubted) {
        if (decision.question() instanceof Question.FillIn) {
            return Set.of();
        }
        List<String> boats = decision.boats();
        boolean aboutWays = DomainQuestion.of(decision.decision().type())
                .filter(DomainQuestion::isAboutWays)
                .isPresent();
        return aboutWays
                ? doubted.map(paths -> paths.byBoat().keySet())
                        .orElseGet(() -> BoatsInText.of(decision.decision().prompt(), boats))
                : Set.copyOf(boats);
    }
}
