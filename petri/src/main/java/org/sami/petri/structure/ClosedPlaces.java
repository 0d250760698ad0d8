package org.sami.petri.structure;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * Sets of places that are closed under a rule "whichever transition touches the set on one side touches it on the other side too". Siphons and traps are such sets:
 *
 * <ul>
 *   <li>a <b>siphon</b>: each transition that produces in it consumes from it. Once empty it stays empty. Inhibitor and reset arcs only help: they bring no tokens.
 *   <li>a <b>trap</b>: each transition that consumes from it, or empties a place of it by a reset arc, produces in it. Once marked it stays marked, as a transition
 *       produces after its resets.
 * </ul>
 *
 * <p>Unions of closed sets are closed, so each set of places has a greatest closed subset.
 *
 * <p>Source: Murata, "Petri nets: properties, analysis and applications", Proceedings of the IEEE 77(4), 1989, section VI.B.
 */
public final class ClosedPlaces {
    private final int places;
    private final int[][] touching;
    private final int[][] needed;
    private final int[][] answeredBy;

    /** For each transition the places that make it touch a set, and those by one of which it must touch the set too. */
    private ClosedPlaces(int places, int[][] touching, int[][] needed) {
        this.places = places;
        this.touching = touching;
        this.needed = needed;
        List<List<Integer>> answered = new ArrayList<>();
        for (int place = 0; place < places; place++) {
            answered.add(new ArrayList<>());
        }
        for (int transition = 0; transition < needed.length; transition++) {
            for (int place : needed[transition]) {
                answered.get(place).add(transition);
            }
        }
        this.answeredBy = answered.stream()
                .map(transitions ->
                        transitions.stream().mapToInt(Integer::intValue).toArray())
                .toArray(int[][]::new);
    }

    /** The siphons of a net. */
    public static ClosedPlaces siphons(PetriNet net) {
        return new ClosedPlaces(net.placeCount(), nodes(net.produced()), nodes(net.consumed()));
    }

    /** The traps of a net. */
    public static ClosedPlaces traps(PetriNet net) {
        int[][] consumed = nodes(net.consumed());
        int[][] emptied = nodes(net.resets());
        int[][] taking = new int[consumed.length][];
        for (int transition = 0; transition < taking.length; transition++) {
            BitSet both = bits(consumed[transition]);
            both.or(bits(emptied[transition]));
            taking[transition] = both.stream().toArray();
        }
        return new ClosedPlaces(net.placeCount(), taking, nodes(net.produced()));
    }

    int places() {
        return places;
    }

    /** The greatest closed subset of a set of places; it may be empty. */
    public BitSet greatestWithin(BitSet allowed) {
        BitSet kept = (BitSet) allowed.clone();
        int[] answers = new int[needed.length];
        Deque<Integer> failed = new ArrayDeque<>();
        for (int transition = 0; transition < needed.length; transition++) {
            for (int place : needed[transition]) {
                answers[transition] += kept.get(place) ? 1 : 0;
            }
            if (answers[transition] == 0) {
                failed.add(transition);
            }
        }
        while (!failed.isEmpty()) {
            for (int place : touching[failed.remove()]) {
                if (kept.get(place)) {
                    kept.clear(place);
                    for (int transition : answeredBy[place]) {
                        if (--answers[transition] == 0) {
                            failed.add(transition);
                        }
                    }
                }
            }
        }
        return kept;
    }

    private static int[][] nodes(ArcTable arcs) {
        int[][] nodes = new int[arcs.rows()][];
        for (int row = 0; row < nodes.length; row++) {
            nodes[row] = new int[arcs.to(row) - arcs.from(row)];
            for (int i = 0; i < nodes[row].length; i++) {
                nodes[row][i] = arcs.node(arcs.from(row) + i);
            }
        }
        return nodes;
    }

    private static BitSet bits(int[] places) {
        BitSet set = new BitSet();
        for (int place : places) {
            set.set(place);
        }
        return set;
    }
}
