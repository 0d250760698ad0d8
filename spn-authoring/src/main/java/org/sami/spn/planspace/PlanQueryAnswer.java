package org.sami.spn.planspace;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.structure.StructuralProof;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNetFiring;

/**
 * What a search says to a query of a plan.
 *
 * @param verdict yes or no where it is proved for the net, else unknown
 * @param isFault whether it is certain that a rule is broken: an invariant, a deadlock, a run that cannot come home, no bound
 * @param words the answer, or what is wrong with the query, in one sentence
 * @param witness a run that shows it; empty where nothing shows it
 * @param proof from the structure of the net, a line each, where that answers; none where states were searched
 * @param states how many states of the net were searched
 * @param nanos how long that took
 */
public record PlanQueryAnswer(
        PlanQuery query,
        Result result,
        NetVerdict verdict,
        boolean isFault,
        String words,
        Optional<PlanWitness> witness,
        List<String> proof,
        int states,
        long nanos) {
    /** How an answer stands to what the author expects. */
    public enum Result {
        EXPECTED,
        UNEXPECTED,
        /** Neither was proved for the plan; {@link #mayBe} says whether its net does it. */
        OPEN,
        /** The query means nothing. */
        FAULT
    }

    public PlanQueryAnswer {
        Objects.requireNonNull(query, "query");
        Objects.requireNonNull(result, "result");
        Objects.requireNonNull(verdict, "verdict");
        Objects.requireNonNull(words, "words");
        Objects.requireNonNull(witness, "witness");
        proof = List.copyOf(proof);
    }

    /** Nothing was searched: the query means nothing, or its plan has no net that could be. */
    public static PlanQueryAnswer without(PlanQuery query, Result result, String words) {
        return new PlanQueryAnswer(query, result, NetVerdict.UNKNOWN, false, words, Optional.empty(), List.of(), 0, 0);
    }

    /** The same with more words behind it. */
    PlanQueryAnswer adding(String more) {
        return new PlanQueryAnswer(query, result, verdict, isFault, words + more, witness, proof, states, nanos);
    }

    /**
     * What the structure of the net proves.
     *
     * @param caution what it hangs on, to follow the method; empty text where on nothing
     */
    static PlanQueryAnswer proved(
            PlanQuery query, Result result, NetVerdict verdict, StructuralProof proof, String caution) {
        String words = verdict.name().toLowerCase(Locale.ROOT) + ": proved by "
                + proof.method().words() + caution;
        return new PlanQueryAnswer(query, result, verdict, false, words, Optional.empty(), proof.words(), 0, 0);
    }

    /** Whether the net does it and the engine was not seen to do it: the net can do more than its plan. */
    public boolean mayBe() {
        return result == Result.OPEN && verdict != NetVerdict.UNKNOWN;
    }

    /** The firings that show it; none where nothing shows it, or the start does. */
    public List<PlanNetFiring> run() {
        return witness.map(PlanWitness::firings).orElse(List.of());
    }

    /** The markings of the run that shows it; none where nothing shows it. */
    public List<PlanMarking> markings() {
        return witness.map(PlanWitness::markings).orElse(List.of());
    }

    /** Whether a run shows the answer. */
    public boolean isShown() {
        return witness.isPresent();
    }
}
