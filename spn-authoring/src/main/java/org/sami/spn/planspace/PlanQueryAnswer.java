package org.sami.spn.planspace;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNetFiring;

/**
 * What a search says to a query of a plan.
 *
 * @param words the answer, or what is wrong with the query, in one sentence
 * @param run firings that show it, the shortest; empty where nothing shows it, or the start does
 * @param markings one more than the run has firings: before the first and after each; empty where nothing shows it
 */
public record PlanQueryAnswer(
        PlanQuery query, Result result, String words, List<PlanNetFiring> run, List<PlanMarking> markings) {
    /** How an answer stands to what the author expects. */
    public enum Result {
        EXPECTED,
        UNEXPECTED,
        /** Neither was proved. */
        OPEN,
        /** The query means nothing. */
        FAULT
    }

    public PlanQueryAnswer {
        Objects.requireNonNull(query, "query");
        Objects.requireNonNull(result, "result");
        Objects.requireNonNull(words, "words");
        run = List.copyOf(run);
        markings = List.copyOf(markings);
    }

    /** Whether a run shows the answer. */
    public boolean isShown() {
        return !markings.isEmpty();
    }
}
