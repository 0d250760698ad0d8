package org.sami.petri.structure;

import org.sami.petri.net.PetriNet;

/**
 * A weighted sum of tokens that no firing makes larger, so that no reachable marking has more than the initial one.
 *
 * @param weights weights of places
 * @param most the sum in the initial marking
 * @param constant whether no firing makes it smaller either (a P-invariant)
 */
public record MarkingBound(IntegerVector weights, long most, boolean constant) {

    /** The bound of weights that never grow ({@link Incidence#neverGrows}). */
    static MarkingBound of(PetriNet net, Incidence incidence, IntegerVector weights) {
        return new MarkingBound(weights, weights.times(net.initialMarking()), incidence.neverChanges(weights));
    }

    /** The most tokens that a place with a positive weight can have, where no weight is negative. */
    public long mostTokens(int place) {
        return most / weights.get(place);
    }

    /** For people: {@code p + q + 2 r is always 3}, or {@code is never more than 3}. */
    public String words(PetriNet net) {
        return weights.words(net::placeName) + (constant ? " is always " : " is never more than ") + most;
    }
}
