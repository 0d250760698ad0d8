package org.sami.petri.graph;

import java.util.List;
import org.sami.petri.net.FiringRule;
import org.sami.petri.net.PetriNet;

/**
 * A run of a net from its initial marking: the numbers of the transitions that fire, one after the other.
 *
 * @param transitions in the order of their firing
 */
public record FiringSequence(List<Integer> transitions) {
    public FiringSequence {
        transitions = List.copyOf(transitions);
    }

    /**
     * Fires it by {@link FiringRule}, which knows nothing of packed states.
     *
     * @return the marking at its end
     * @throws IllegalArgumentException if a transition is not enabled at its turn
     */
    public int[] replay(PetriNet net) {
        int[] marking = net.initialMarking();
        for (int transition : transitions) {
            marking = FiringRule.fire(net, transition, marking);
        }
        return marking;
    }

    /** The ids of the transitions. */
    public List<String> ids(PetriNet net) {
        return transitions.stream().map(net::transitionId).toList();
    }
}
