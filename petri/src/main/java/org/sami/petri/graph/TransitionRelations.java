package org.sami.petri.graph;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/** Which transitions of a net can influence one another, found when they are asked for. For one thread. */
final class TransitionRelations {
    /** So many numbers of dependent transitions are kept; more are computed anew each time, as they grow with the square of the transitions. */
    static final int MOST_KEPT = 1 << 23;

    private final PetriNet net;
    private final ArcTable consumers;
    private final ArcTable producers;
    private final ArcTable inhibited;
    private final ArcTable resetters;
    private final int[] @Nullable [] dependent;
    private final int[] @Nullable [] raising;
    private final int[] @Nullable [] lowering;
    private int kept;

    TransitionRelations(PetriNet net) {
        this.net = net;
        consumers = net.consumed().transposed(net.placeCount());
        producers = net.produced().transposed(net.placeCount());
        inhibited = net.inhibitors().transposed(net.placeCount());
        resetters = net.resets().transposed(net.placeCount());
        dependent = new int[net.transitionCount()][];
        raising = new int[net.placeCount()][];
        lowering = new int[net.placeCount()][];
    }

    /**
     * The transitions that may leave more tokens in a place than there were. One that resets the place and does not produce more than it consumes leaves no more
     * than it found.
     */
    int[] raising(int place) {
        int[] known = raising[place];
        if (known == null) {
            BitSet set = new BitSet();
            for (int arc = producers.from(place); arc < producers.to(place); arc++) {
                int t = producers.node(arc);
                if (producers.weight(arc) > consumers.weight(place, t)) {
                    set.set(t);
                }
            }
            known = set.stream().toArray();
            raising[place] = known;
        }
        return known;
    }

    /** The transitions that may leave fewer tokens in a place than there were. */
    int[] lowering(int place) {
        int[] known = lowering[place];
        if (known == null) {
            BitSet set = new BitSet();
            for (int arc = consumers.from(place); arc < consumers.to(place); arc++) {
                if (consumers.weight(arc) > producers.weight(place, consumers.node(arc))) {
                    set.set(consumers.node(arc));
                }
            }
            addAll(resetters, place, set);
            known = set.stream().toArray();
            lowering[place] = known;
        }
        return known;
    }

    /** The transitions that can disable a transition, can be disabled by it, or lead elsewhere when both fire in another order. */
    int[] dependentOn(int transition) {
        int[] known = dependent[transition];
        if (known == null) {
            BitSet set = new BitSet();
            for (int place : places(net.consumed(), transition)) {
                addAll(consumers, place, set);
                addAll(resetters, place, set);
            }
            for (int place : places(net.produced(), transition)) {
                addAll(inhibited, place, set);
                addAll(resetters, place, set);
            }
            for (int place : places(net.inhibitors(), transition)) {
                for (int other : raising(place)) {
                    set.set(other);
                }
            }
            for (int place : places(net.resets(), transition)) {
                addAll(consumers, place, set);
                addAll(producers, place, set); // who only resets it too leaves it empty in any order
            }
            set.clear(transition);
            known = set.stream().toArray();
            if (known.length <= MOST_KEPT - kept) {
                kept += known.length;
                dependent[transition] = known;
            }
        }
        return known;
    }

    /** How many numbers of dependent transitions are kept. */
    int kept() {
        return kept;
    }

    private static List<Integer> places(ArcTable arcs, int transition) {
        List<Integer> places = new ArrayList<>();
        for (int arc = arcs.from(transition); arc < arcs.to(transition); arc++) {
            places.add(arcs.node(arc));
        }
        return places;
    }

    private static void addAll(ArcTable arcs, int place, BitSet into) {
        for (int arc = arcs.from(place); arc < arcs.to(place); arc++) {
            into.set(arcs.node(arc));
        }
    }
}
