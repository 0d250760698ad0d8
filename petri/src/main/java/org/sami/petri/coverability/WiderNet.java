package org.sami.petri.coverability;

import java.util.BitSet;
import org.sami.petri.net.PetriNet;

/**
 * A net that stands for one with more markings and fewer firings: each firing of that one has its image here, so what this net never does that one never does.
 *
 * @param presence places that only say whether that one has tokens in some of its places
 * @param sure transitions that it can fire from each marking of which one here is the image, coming to one of which the next is the image
 */
public record WiderNet(PetriNet net, BitSet presence, BitSet sure) {
    public WiderNet {
        presence = (BitSet) presence.clone();
        sure = (BitSet) sure.clone();
    }

    /** A net that stands for itself. */
    public static WiderNet exact(PetriNet net) {
        BitSet all = new BitSet();
        all.set(0, net.transitionCount());
        return new WiderNet(net, new BitSet(), all);
    }

    @Override
    public BitSet presence() {
        return (BitSet) presence.clone();
    }

    @Override
    public BitSet sure() {
        return (BitSet) sure.clone();
    }

    /** Whether it stands for no other net. */
    boolean isExact() {
        return presence.isEmpty() && sure.cardinality() == net.transitionCount();
    }

    boolean isSure(int transition) {
        return sure.get(transition);
    }
}
