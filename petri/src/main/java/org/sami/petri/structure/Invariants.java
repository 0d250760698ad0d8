package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.petri.net.PetriNet;

/**
 * Invariants of nets.
 *
 * <p>A <b>P-invariant</b> weighs places so that no firing changes the weighted sum of tokens: it is the same in all reachable markings. Inhibitor arcs do not matter. A
 * place that a reset arc empties has the weight 0 in every P-invariant, as its tokens can go at any firing of that arc; a weighted sum with it can still be known never
 * to grow ({@link PlaceBounds}).
 *
 * <p>A <b>T-invariant</b> is a number of firings of each transition that together change nothing: a run with exactly these firings ends where it began. Whether there is
 * such a run it does not say. Transitions with a reset arc are in none, as what they change depends on the marking.
 *
 * <p>Source: Murata, "Petri nets: properties, analysis and applications", Proceedings of the IEEE 77(4), 1989, section VII.
 */
public final class Invariants {
    private Invariants() {}

    /** The minimal P-invariants without negative weights. */
    public static InvariantSet ofPlaces(PetriNet net, StructureLimits limits) {
        Incidence incidence = Incidence.of(net);
        return SemiPositiveSolutions.of(
                incidence.rows(), incidence.columns().size(), limits.rows(), limits.cancelled());
    }

    /** The minimal T-invariants. */
    public static InvariantSet ofTransitions(PetriNet net, StructureLimits limits) {
        List<IntegerVector> columns =
                new ArrayList<>(Incidence.of(net).columns().subList(0, net.transitionCount()));
        for (int transition = 0; transition < columns.size(); transition++) {
            if (!net.resets().isEmpty(transition)) {
                // an equation of its own, which nothing but 0 solves
                columns.set(transition, IntegerVector.unit(net.placeCount(), 1));
            }
        }
        return SemiPositiveSolutions.of(columns, net.placeCount() + 1, limits.rows(), limits.cancelled());
    }

    /**
     * A basis of all P-invariants, those with negative weights too: each is exactly one sum of these with whole factors. Empty where its numbers are too large or the
     * search was cancelled.
     */
    public static Optional<List<IntegerVector>> basisOfPlaces(PetriNet net, StructureLimits limits) {
        Incidence incidence = Incidence.of(net);
        return IntegerKernel.of(incidence.rows(), incidence.columns().size(), limits.cancelled());
    }
}
