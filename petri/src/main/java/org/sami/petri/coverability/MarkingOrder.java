package org.sami.petri.coverability;

import java.util.BitSet;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * When a marking covers another: it has at least as many tokens in each place, and exactly as many in each place with an inhibitor or reset arc. What can fire in the
 * smaller one can then fire in the larger one, to markings in the same order: so a run from a marking to one that covers it can be repeated for ever, and adds the same
 * each time. Places with exact numbers never become unbounded in a search that compares so; where such a place is unbounded, the search does not end.
 */
final class MarkingOrder {
    private final BitSet exact = new BitSet();
    private final int[] exactPlaces;

    MarkingOrder(PetriNet net) {
        addNodes(net.inhibitors());
        addNodes(net.resets());
        exactPlaces = exact.stream().toArray();
    }

    private void addNodes(ArcTable arcs) {
        for (int arc = 0; arc < arcs.size(); arc++) {
            exact.set(arcs.node(arc));
        }
    }

    /** The places in which numbers of tokens must be equal. */
    int[] exactPlaces() {
        return exactPlaces.clone();
    }

    /** Whether one marking covers another. */
    boolean covers(int[] large, int[] small) {
        for (int place = 0; place < large.length; place++) {
            if (small[place] > large[place]) {
                return false;
            }
        }
        return agree(large, small);
    }

    /** Whether two markings are equal in the places with exact numbers. */
    private boolean agree(int[] first, int[] second) {
        for (int place : exactPlaces) {
            if (first[place] != second[place]) {
                return false;
            }
        }
        return true;
    }

    /** Equal for markings that agree. */
    int hashOfExactPlaces(int[] marking) {
        int hash = 1;
        for (int place : exactPlaces) {
            hash = 31 * hash + marking[place];
        }
        return hash;
    }
}
