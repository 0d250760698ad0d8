package org.sami.petri.graph;

import java.util.Arrays;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * Finds the transitions that are enabled in a marking. Each transition is looked at only where one of the places that it consumes from, its key, has tokens, so
 * that a large net with few tokens costs little. The order is the same for equal markings. Immutable.
 */
final class EnabledTransitions {
    private final ArcTable consumed;
    private final ArcTable inhibitors;
    private final boolean inhibits;
    private final int[] keyless;
    private final int[] start;
    private final int[] byKey;

    EnabledTransitions(PetriNet net) {
        consumed = net.consumed();
        inhibitors = net.inhibitors();
        inhibits = inhibitors.size() > 0;
        int[] key = keys(net);
        start = new int[net.placeCount() + 1];
        int without = 0;
        for (int place : key) {
            if (place < 0) {
                without++;
            } else {
                start[place + 1]++;
            }
        }
        for (int place = 0; place < net.placeCount(); place++) {
            start[place + 1] += start[place];
        }
        keyless = new int[without];
        byKey = new int[key.length - without];
        int[] next = start.clone();
        without = 0;
        for (int t = 0; t < key.length; t++) {
            if (key[t] < 0) {
                keyless[without++] = t;
            } else {
                byKey[next[key[t]]++] = t;
            }
        }
    }

    /** For each transition the place with the fewest consumers among those that it consumes from; -1 where it consumes nothing. */
    private static int[] keys(PetriNet net) {
        int[] consumers = new int[net.placeCount()];
        ArcTable consumed = net.consumed();
        for (int arc = 0; arc < consumed.size(); arc++) {
            consumers[consumed.node(arc)]++;
        }
        int[] keys = new int[net.transitionCount()];
        Arrays.fill(keys, -1);
        for (int t = 0; t < keys.length; t++) {
            for (int arc = consumed.from(t); arc < consumed.to(t); arc++) {
                int place = consumed.node(arc);
                if (keys[t] < 0 || consumers[place] < consumers[keys[t]]) {
                    keys[t] = place;
                }
            }
        }
        return keys;
    }

    /** Writes the enabled transitions into an array that has room for all transitions; returns how many there are. */
    int find(int[] marking, int[] into) {
        int count = 0;
        for (int t : keyless) {
            if (isEnabled(t, marking)) {
                into[count++] = t;
            }
        }
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] > 0) {
                for (int i = start[place]; i < start[place + 1]; i++) {
                    if (isEnabled(byKey[i], marking)) {
                        into[count++] = byKey[i];
                    }
                }
            }
        }
        return count;
    }

    private boolean isEnabled(int transition, int[] marking) {
        for (int arc = consumed.from(transition), end = consumed.to(transition); arc < end; arc++) {
            if (marking[consumed.node(arc)] < consumed.weight(arc)) {
                return false;
            }
        }
        return !inhibits || !isInhibited(transition, marking);
    }

    private boolean isInhibited(int transition, int[] marking) {
        for (int arc = inhibitors.from(transition); arc < inhibitors.to(transition); arc++) {
            if (marking[inhibitors.node(arc)] >= inhibitors.weight(arc)) {
                return true;
            }
        }
        return false;
    }
}
