package org.sami.petri.coverability;

import java.util.BitSet;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/** The places of a net of which no arc tells more than one token from one. Immutable. */
public final class SaturablePlaces {
    private final PetriNet net;
    private final BitSet places = new BitSet();
    private final BitSet exact = new BitSet();

    /** Those of a net. */
    public SaturablePlaces(PetriNet net) {
        this.net = net;
        places.set(0, net.placeCount());
        exact.set(0, net.placeCount());
        strike(net.consumed());
        strike(net.inhibitors());
        BitSet last = last(net);
        for (int t = 0; t < net.transitionCount(); t++) {
            for (int arc = net.consumed().from(t); arc < net.consumed().to(t); arc++) {
                int place = net.consumed().node(arc);
                if (!last.get(t) && lowersByOne(t, place)) {
                    exact.clear(place);
                }
            }
        }
    }

    private void strike(ArcTable arcs) {
        for (int arc = 0; arc < arcs.size(); arc++) {
            if (arcs.weight(arc) > 1) {
                places.clear(arcs.node(arc));
            }
        }
    }

    /** The transitions after which nothing is enabled any more, as they take the last token of a place that all need and none fills. */
    private static BitSet last(PetriNet net) {
        BitSet last = new BitSet();
        int[] needed = new int[net.placeCount()];
        BitSet raised = new BitSet();
        for (int t = 0; t < net.transitionCount(); t++) {
            for (int arc = net.consumed().from(t); arc < net.consumed().to(t); arc++) {
                needed[net.consumed().node(arc)]++;
            }
            for (int arc = net.produced().from(t); arc < net.produced().to(t); arc++) {
                int place = net.produced().node(arc);
                if (net.produced().weight(arc) > net.consumed().weight(t, place)) {
                    raised.set(place);
                }
            }
        }
        for (int place = 0; place < needed.length; place++) {
            if (net.initial(place) == 1 && needed[place] == net.transitionCount() && !raised.get(place)) {
                for (int t = 0; t < net.transitionCount(); t++) {
                    last.set(t, last.get(t) || net.produced().weight(t, place) == 0);
                }
            }
        }
        return last;
    }

    /** Whether a transition consumes a token of a place and leaves the others there. */
    boolean lowersByOne(int transition, int place) {
        return net.consumed().weight(transition, place) == 1
                && net.produced().weight(transition, place) == 0
                && net.resets().weight(transition, place) == 0;
    }

    /** Whether a place is one of them. */
    public boolean contains(int place) {
        return places.get(place);
    }

    /** Whether it does not matter how many tokens a place has as long as it has one: who lowers that number ends all. */
    boolean isExact(int place) {
        return exact.get(place);
    }

    /** All of them. */
    public BitSet all() {
        return (BitSet) places.clone();
    }
}
