package org.sami.spn.engine.codec;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Token;

/**
 * The tokens of one place as they are read, each with its order of entry and its visit. Tokens enter by a visit one after the other, so their orders say which of
 * the tokens of the visit they are.
 */
final class StandingTokens {
    private record Standing(Token token, long order) {}

    private final Map<Visit, List<Standing>> byVisit = new LinkedHashMap<>();

    /** Adds the next token of the place, in order of entry. */
    void add(Visit visit, Token token, long order) {
        byVisit.computeIfAbsent(visit, v -> new ArrayList<>()).add(new Standing(token, order));
    }

    /**
     * Puts them into the marking.
     *
     * @throws IllegalArgumentException if they cannot have entered by these visits
     */
    void enter() {
        byVisit.forEach(StandingTokens::enter);
    }

    private static void enter(Visit visit, List<Standing> tokens) {
        for (int first = 0; first < visit.entered.size(); first++) {
            List<Integer> positions = positions(visit.entered, tokens, first);
            if (positions.size() == tokens.size()) {
                visit.enter(tokens.get(0).order() - first, positions);
                return;
            }
        }
        throw new IllegalArgumentException("Tokens stand in a place that did not enter it by visit " + visit.id);
    }

    /** Where tokens are among those that entered, if the first of them is at a position; fewer where one of them is not there. */
    private static List<Integer> positions(List<Token> entered, List<Standing> tokens, int first) {
        List<Integer> positions = new ArrayList<>(tokens.size());
        for (Standing one : tokens) {
            long at = first + one.order() - tokens.get(0).order();
            if (at < first || at >= entered.size() || !entered.get((int) at).equals(one.token())) {
                break;
            }
            positions.add((int) at);
        }
        return positions;
    }
}
