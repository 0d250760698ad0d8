package org.sami.spn.planspace;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.TestCase;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNetFiring;

/**
 * A run that shows an answer.
 *
 * @param firings the fewest that lead there; none where the start shows it
 * @param markings one more than there are firings: before the first and after each
 * @param words a sentence for each firing, with transitions and places by their names
 * @param endWords the marked places at the end by their names, each with its tokens
 * @param steps by which the engine comes there, to be played; empty where none were found: then it is a run of the net, and may be none of the plan
 */
public record PlanWitness(
        List<PlanNetFiring> firings,
        List<PlanMarking> markings,
        List<String> words,
        List<String> endWords,
        Optional<TestCase> steps) {
    public PlanWitness {
        firings = List.copyOf(firings);
        markings = List.copyOf(markings);
        words = List.copyOf(words);
        endWords = List.copyOf(endWords);
        Objects.requireNonNull(steps, "steps");
        if (markings.size() != firings.size() + 1 || words.size() != firings.size()) {
            throw new IllegalArgumentException(
                    firings.size() + " firings have one marking more and as many sentences, not " + markings.size()
                            + " and " + words.size());
        }
    }

    /** The marking at its end. */
    public PlanMarking end() {
        return markings.get(markings.size() - 1);
    }
}
