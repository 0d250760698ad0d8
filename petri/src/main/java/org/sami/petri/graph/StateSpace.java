package org.sami.petri.graph;

import java.util.Arrays;
import org.sami.petri.net.PetriNet;

/** The states that a search has found, in a layout that becomes wider where a place has more tokens than its field holds. For one thread. */
final class StateSpace {
    /** After so many places whose fields became wider, all fields of the same width follow: a net of many places is packed again a few dozen times. */
    private static final int SINGLE_WIDENINGS = 16;

    private final PetriNet net;
    private StateLayout layout;
    private final StateTable table;
    private PackedFiring firing;
    private long[] packed;
    private int widenings;

    StateSpace(PetriNet net) {
        this.net = net;
        int[] bits = new int[net.placeCount()];
        for (int place = 0; place < bits.length; place++) {
            bits[place] = StateLayout.bitsFor(net.initial(place));
        }
        layout = new StateLayout(bits);
        table = new StateTable(layout.words());
        firing = new PackedFiring(net, layout);
        packed = new long[layout.words()];
    }

    StateTable table() {
        return table;
    }

    PackedFiring firing() {
        return firing;
    }

    int words() {
        return layout.words();
    }

    /** Reads a state as a marking. */
    void load(int state, long[] into, int[] marking) {
        table.load(state, into);
        layout.unpack(into, marking);
    }

    /** Packs a marking; whether the fields have room for it. */
    boolean pack(int[] marking, long[] into) {
        return layout.pack(marking, into);
    }

    /** The first place whose field is too small for a marking; {@link PackedFiring#FITS} where there is none. */
    int overflow(int[] marking) {
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] > layout.most(place)) {
                return place;
            }
        }
        return PackedFiring.FITS;
    }

    /** The number of a marking's state; -1 where it was not found. */
    int find(int[] marking) {
        return layout.pack(marking, packed) ? table.find(packed) : -1;
    }

    long bytes() {
        return table.bytes();
    }

    /**
     * Makes the field of a place wide enough for a number of tokens, and packs all states again; their numbers stay.
     *
     * @param room how many bytes more the states may take
     * @return false, with nothing changed, where they would take more
     */
    boolean widen(int place, int tokens, long room) {
        int old = layout.bits(place);
        int wide = StateLayout.bitsFor(tokens);
        boolean all = ++widenings % SINGLE_WIDENINGS == 0;
        int[] bits = new int[net.placeCount()];
        Arrays.setAll(bits, p -> p == place || (all && layout.bits(p) == old) ? wide : layout.bits(p));
        StateLayout wider = new StateLayout(bits);
        if (table.bytesToRepack(wider.words()) > room) {
            return false;
        }
        table.repack(layout, wider);
        layout = wider;
        firing = new PackedFiring(net, wider);
        packed = new long[wider.words()];
        return true;
    }
}
