package org.sami.petri.structure;

import java.util.List;
import org.sami.petri.net.PetriNet;

/** The proof that no reachable marking fulfils a condition: a contradiction for each case. Where the condition cannot hold in any marking there are no cases. */
public final class Refutation {
    private final List<RefutedCase> cases;
    private final boolean programmed;
    private final PetriNet net;
    private final Incidence incidence;

    Refutation(List<RefutedCase> cases, boolean programmed, PetriNet net, Incidence incidence) {
        this.cases = List.copyOf(cases);
        this.programmed = programmed;
        this.net = net;
        this.incidence = incidence;
    }

    /** Whether P-invariants alone prove it, without a linear program. */
    public boolean byInvariants() {
        return !programmed;
    }

    /** The weighted sums of tokens that prove it, where no case is distinguished by numbers of firings. */
    List<MarkingBound> bounds() {
        return cases.stream()
                .filter(one -> !one.usesLimits(net))
                .map(one -> MarkingBound.of(net, incidence, one.weights(net)))
                .distinct()
                .toList();
    }

    /** For people: one line a case, none twice. */
    public List<String> words() {
        return cases.stream().map(one -> one.words(net, incidence)).distinct().toList();
    }

    /** Whether each case is proved by exact arithmetic; every refutation that is handed out is. */
    boolean isProof() {
        return cases.stream().allMatch(one -> one.isProof(net, incidence));
    }
}
