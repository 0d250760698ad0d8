package org.sami.petri.net;

import java.util.List;
import java.util.Map;
import java.util.OptionalInt;

/**
 * A place/transition net with its initial marking. Places and transitions are numbered from 0 in the order in which they were added; a marking is an {@code int[]}
 * with the tokens of each place. A transition is enabled where each place has at least as many tokens as it consumes, and fewer than the weight of each of its
 * inhibitor arcs. It consumes, then empties the places of its reset arcs, then produces ({@link FiringRule}). Ids of places are unique among places, ids of
 * transitions among transitions; a place and a transition may have the same id. Immutable; made by a {@link PetriNetBuilder}.
 *
 * <p>Source: thesis, section 4.2, with the inhibitor and reset arcs that section 4.1 needs.
 */
public final class PetriNet {
    private final String name;
    private final Nodes places;
    private final Nodes transitions;
    private final int[] initial;
    private final ArcTable consumed;
    private final ArcTable produced;
    private final ArcTable inhibitors;
    private final ArcTable resets;

    /** Ids and names of places or of transitions, by number. */
    record Nodes(List<String> ids, List<String> names, Map<String, Integer> numbers) {
        OptionalInt number(String id) {
            Integer number = numbers.get(id);
            return number == null ? OptionalInt.empty() : OptionalInt.of(number);
        }
    }

    PetriNet(
            String name,
            Nodes places,
            Nodes transitions,
            int[] initial,
            ArcTable consumed,
            ArcTable produced,
            ArcTable inhibitors,
            ArcTable resets) {
        this.name = name;
        this.places = places;
        this.transitions = transitions;
        this.initial = initial;
        this.consumed = consumed;
        this.produced = produced;
        this.inhibitors = inhibitors;
        this.resets = resets;
    }

    /** The name of the net, for people; may be empty. */
    public String name() {
        return name;
    }

    /** How many places there are. */
    public int placeCount() {
        return initial.length;
    }

    /** How many transitions there are. */
    public int transitionCount() {
        return transitions.ids().size();
    }

    public String placeId(int place) {
        return places.ids().get(place);
    }

    /** The name of a place for people: its id where it has no name of its own. */
    public String placeName(int place) {
        return places.names().get(place);
    }

    public String transitionId(int transition) {
        return transitions.ids().get(transition);
    }

    /** The name of a transition for people: its id where it has no name of its own. */
    public String transitionName(int transition) {
        return transitions.names().get(transition);
    }

    /** The place with an id; empty where there is none. */
    public OptionalInt place(String id) {
        return places.number(id);
    }

    /** The transition with an id; empty where there is none. */
    public OptionalInt transition(String id) {
        return transitions.number(id);
    }

    /** The tokens of a place in the initial marking. */
    public int initial(int place) {
        return initial[place];
    }

    /** The initial marking: a new array at each call. */
    public int[] initialMarking() {
        return initial.clone();
    }

    /** The arcs from places to transitions: rows are transitions. */
    public ArcTable consumed() {
        return consumed;
    }

    /** The arcs from transitions to places: rows are transitions. */
    public ArcTable produced() {
        return produced;
    }

    /** The inhibitor arcs: rows are transitions. A transition is disabled where a place has the weight or more tokens. */
    public ArcTable inhibitors() {
        return inhibitors;
    }

    /** The reset arcs: rows are transitions, all weights are 1. */
    public ArcTable resets() {
        return resets;
    }

    /** Whether there is any inhibitor or reset arc: then more tokens may enable less, and coverability and invariants by firing counts do not apply. */
    public boolean isPlain() {
        return inhibitors.size() == 0 && resets.size() == 0;
    }

    @Override
    public String toString() {
        return (name.isEmpty() ? "net" : name) + " (" + placeCount() + " places, " + transitionCount()
                + " transitions)";
    }
}
