package org.sami.petri.structure;

import java.util.List;
import java.util.Optional;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.LinearCondition.AtLeast;

/** Refutes conditions "a place has so many tokens or more" by one P-invariant: together they ask for more than its sum. Needs no linear program. */
final class InvariantRefuter {
    private InvariantRefuter() {}

    static Optional<RefutedCase> refute(
            PetriNet net, Incidence incidence, InvariantSet invariants, FarkasSystem system, List<AtLeast> conditions) {
        int[] initial = net.initialMarking();
        for (IntegerVector invariant : invariants.invariants()) {
            if (needed(invariant, conditions) > invariant.times(initial)) {
                RefutedCase refuted = system.refuted(factors(net, invariant, conditions));
                if (refuted.isProof(net, incidence)) {
                    return Optional.of(refuted);
                }
            }
        }
        return Optional.empty();
    }

    /** How large the sum of an invariant is at least where the conditions hold. */
    private static long needed(IntegerVector invariant, List<AtLeast> conditions) {
        long needed = 0;
        for (int i = 0; i < invariant.size(); i++) {
            int strongest = strongest(conditions, invariant.indexAt(i));
            if (strongest >= 0) {
                long least = conditions.get(strongest).least();
                needed = Math.addExact(needed, Math.multiplyExact(invariant.valueAt(i), least));
            }
        }
        return needed;
    }

    /** The factors by which the conditions make up the invariant: for each of its places the strongest condition, or the place itself. */
    private static IntegerVector factors(PetriNet net, IntegerVector invariant, List<AtLeast> conditions) {
        long[] factors = new long[conditions.size() + net.placeCount()];
        for (int i = 0; i < invariant.size(); i++) {
            int place = invariant.indexAt(i);
            int strongest = strongest(conditions, place);
            factors[strongest < 0 ? conditions.size() + place : strongest] = invariant.valueAt(i);
        }
        return IntegerVector.of(factors);
    }

    private static int strongest(List<AtLeast> conditions, int place) {
        int best = -1;
        for (int i = 0; i < conditions.size(); i++) {
            AtLeast condition = conditions.get(i);
            boolean ofPlace = condition.weights().size() == 1
                    && condition.weights().indexAt(0) == place
                    && condition.weights().valueAt(0) == 1;
            if (ofPlace && (best < 0 || condition.least() > conditions.get(best).least())) {
                best = i;
            }
        }
        return best;
    }
}
