package org.sami.petri.structure;

import java.util.List;

/**
 * Invariants of a net as weights of places, or counts of transitions: whole numbers of 0 or more, divided by what all share.
 *
 * @param complete whether these are all minimal ones; where not, each is an invariant all the same, but there may be others, and smaller ones
 */
public record InvariantSet(List<IntegerVector> invariants, boolean complete) {
    public InvariantSet {
        invariants = List.copyOf(invariants);
    }
}
