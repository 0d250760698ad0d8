package org.sami.petri.symmetry;

import java.util.Arrays;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/** A permutation of the places and transitions of a net. Immutable. */
final class NetPermutation {
    private final int[] places;
    private final int[] transitions;

    /** The places that it moves, in ascending order. */
    private final int[] moved;

    /** Those of the moved places that have to be compared with their images: one of each two that are exchanged. */
    private final int[] compared;

    NetPermutation(int[] places, int[] transitions) {
        this.places = places;
        this.transitions = transitions;
        int[] all = new int[places.length];
        int count = 0;
        for (int place = 0; place < places.length; place++) {
            if (places[place] != place) {
                all[count++] = place;
            }
        }
        moved = Arrays.copyOf(all, count);
        boolean isExchange = Arrays.stream(moved).allMatch(place -> places[places[place]] == place);
        compared = isExchange
                ? Arrays.stream(moved).filter(place -> place < places[place]).toArray()
                : moved;
    }

    int place(int place) {
        return places[place];
    }

    boolean moves(int place) {
        return places[place] != place;
    }

    int transition(int transition) {
        return transitions[transition];
    }

    int[] moved() {
        return moved;
    }

    /** Whether the net with its initial marking is the same afterwards. */
    boolean keeps(PetriNet net) {
        for (int place : moved) {
            if (net.initial(place) != net.initial(places[place])) {
                return false;
            }
        }
        return keeps(net.consumed()) && keeps(net.produced()) && keeps(net.inhibitors()) && keeps(net.resets());
    }

    private boolean keeps(ArcTable arcs) {
        for (int t = 0; t < transitions.length; t++) {
            int other = transitions[t];
            if (arcs.to(t) - arcs.from(t) != arcs.to(other) - arcs.from(other)) {
                return false;
            }
            for (int arc = arcs.from(t); arc < arcs.to(t); arc++) {
                if (arcs.weight(other, places[arcs.node(arc)]) != arcs.weight(arc)) {
                    return false;
                }
            }
        }
        return true;
    }

    /**
     * Moves the tokens of a marking where that makes it larger, place by place from the first one.
     *
     * @param room for as many tokens as it moves places
     * @return whether it did
     */
    boolean enlarge(int[] marking, int[] room) {
        for (int place : compared) {
            int change = marking[places[place]] - marking[place];
            if (change < 0) {
                return false;
            }
            if (change > 0) {
                apply(marking, room);
                return true;
            }
        }
        return false;
    }

    /** Whether a marking is the same afterwards. */
    boolean fixes(int[] marking) {
        for (int place : compared) {
            if (marking[places[place]] != marking[place]) {
                return false;
            }
        }
        return true;
    }

    private void apply(int[] marking, int[] room) {
        for (int i = 0; i < moved.length; i++) {
            room[i] = marking[places[moved[i]]];
        }
        for (int i = 0; i < moved.length; i++) {
            marking[moved[i]] = room[i];
        }
    }
}
