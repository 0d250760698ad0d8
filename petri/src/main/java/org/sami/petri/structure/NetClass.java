package org.sami.petri.structure;

import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * Classes of nets on which theorems rest.
 *
 * <p>Source: Desel and Esparza, "Free Choice Petri Nets", 1995, chapters 2 and 4.
 */
final class NetClass {
    private NetClass() {}

    /** Whether each transition consumes at most one token of each place. */
    static boolean consumesSingleTokens(PetriNet net) {
        return weightsAreOne(net.consumed());
    }

    /** Whether all weights are 1 and there are no inhibitor and reset arcs. */
    static boolean isOrdinary(PetriNet net) {
        return net.isPlain() && weightsAreOne(net.consumed()) && weightsAreOne(net.produced());
    }

    /** Whether an ordinary net is free-choice: transitions that share one place to consume from share all of them. */
    static boolean isFreeChoice(PetriNet net) {
        if (!isOrdinary(net)) {
            return false;
        }
        ArcTable consumers = net.consumed().transposed(net.placeCount());
        for (int place = 0; place < net.placeCount(); place++) {
            for (int arc = consumers.from(place) + 1; arc < consumers.to(place); arc++) {
                if (!sameRow(net.consumed(), consumers.node(arc - 1), consumers.node(arc))) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean weightsAreOne(ArcTable arcs) {
        for (int arc = 0; arc < arcs.size(); arc++) {
            if (arcs.weight(arc) != 1) {
                return false;
            }
        }
        return true;
    }

    private static boolean sameRow(ArcTable arcs, int first, int second) {
        int size = arcs.to(first) - arcs.from(first);
        if (size != arcs.to(second) - arcs.from(second)) {
            return false;
        }
        for (int i = 0; i < size; i++) {
            if (arcs.node(arcs.from(first) + i) != arcs.node(arcs.from(second) + i)) {
                return false;
            }
        }
        return true;
    }
}
