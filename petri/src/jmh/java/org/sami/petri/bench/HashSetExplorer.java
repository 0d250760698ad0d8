package org.sami.petri.bench;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/** Explores a net as one writes it first: each marking an object in a hash set, and all transitions tried in each. The measure for the real search. */
final class HashSetExplorer {
    private final PetriNet net;
    private long edges;

    /** A marking with its hash, which is computed once. */
    private static final class Marking {
        private final int[] tokens;
        private final int hash;

        Marking(int[] tokens) {
            this.tokens = tokens;
            hash = Arrays.hashCode(tokens);
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Marking marking && Arrays.equals(tokens, marking.tokens);
        }

        @Override
        public int hashCode() {
            return hash;
        }
    }

    HashSetExplorer(PetriNet net) {
        this.net = net;
    }

    /** Explores the whole graph; returns the number of states. */
    int explore() {
        Marking initial = new Marking(net.initialMarking());
        Set<Marking> known = new HashSet<>(Set.of(initial));
        Deque<Marking> open = new ArrayDeque<>(Set.of(initial));
        while (!open.isEmpty()) {
            int[] marking = open.poll().tokens;
            for (int t = 0; t < net.transitionCount(); t++) {
                if (isEnabled(t, marking)) {
                    edges++;
                    Marking next = new Marking(fire(t, marking));
                    if (known.add(next)) {
                        open.add(next);
                    }
                }
            }
        }
        return known.size();
    }

    long edges() {
        return edges;
    }

    private boolean isEnabled(int t, int[] marking) {
        ArcTable consumed = net.consumed();
        for (int arc = consumed.from(t); arc < consumed.to(t); arc++) {
            if (marking[consumed.node(arc)] < consumed.weight(arc)) {
                return false;
            }
        }
        return true;
    }

    private int[] fire(int t, int[] marking) {
        int[] next = marking.clone();
        ArcTable consumed = net.consumed();
        for (int arc = consumed.from(t); arc < consumed.to(t); arc++) {
            next[consumed.node(arc)] -= consumed.weight(arc);
        }
        ArcTable produced = net.produced();
        for (int arc = produced.from(t); arc < produced.to(t); arc++) {
            next[produced.node(arc)] += produced.weight(arc);
        }
        return next;
    }
}
