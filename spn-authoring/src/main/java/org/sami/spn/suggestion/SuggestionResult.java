package org.sami.spn.suggestion;

import java.util.List;
import java.util.Objects;

/**
 * The suggestions for an edge.
 *
 * @param suggestions the best first; each leaves fewer findings than the edge as it stands
 * @param findings how many findings the plan has with the edge as it stands
 * @param tried how many candidates were judged
 * @param candidates how many there were to judge
 * @param states how many states were looked at
 * @param summary one sentence: what was tried, and what came of it
 */
public record SuggestionResult(
        List<Suggestion> suggestions, int findings, int tried, int candidates, int states, String summary) {
    public SuggestionResult {
        suggestions = List.copyOf(suggestions);
        Objects.requireNonNull(summary, "summary");
    }
}
