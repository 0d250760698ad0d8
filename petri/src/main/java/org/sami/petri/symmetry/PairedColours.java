package org.sami.petri.symmetry;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * Colours of the nodes of a net and of a copy of it, refined together until nodes of one colour have neighbours of the same colours. A node of the net can be mapped
 * to those nodes of the copy that have its colour, and to no others. Nodes are numbered places first, then transitions, then those of the copy. Where that takes too much work, colours stay coarser. For one thread.
 */
final class PairedColours {
    private static final int NODE = 4;

    private final int nodes;
    private final int[] start;
    private final int[] neighbour;
    private final long[] label;
    private final long mostWork;
    private int[] colour;
    private int colours;
    private long work;

    /** An old colour with the sum of what the neighbours say. */
    private record Signature(int colour, long neighbours) {}

    /** Colours of a net, refined with so much work at most, and one round. */
    PairedColours(PetriNet net, long mostWork) {
        this.mostWork = mostWork;
        int places = net.placeCount();
        nodes = places + net.transitionCount();
        List<ArcTable> kinds = List.of(net.consumed(), net.produced(), net.inhibitors(), net.resets());
        start = new int[nodes + 1];
        for (ArcTable arcs : kinds) {
            for (int t = 0; t < net.transitionCount(); t++) {
                start[places + t + 1] += arcs.to(t) - arcs.from(t);
                for (int arc = arcs.from(t); arc < arcs.to(t); arc++) {
                    start[arcs.node(arc) + 1]++;
                }
            }
        }
        for (int node = 0; node < nodes; node++) {
            start[node + 1] += start[node];
        }
        neighbour = new int[start[nodes]];
        label = new long[start[nodes]];
        fill(net, kinds);
        colour = new int[2 * nodes];
        for (int place = 0; place < places; place++) {
            colour[place] = net.initial(place);
            colour[nodes + place] = net.initial(place);
        }
        Arrays.fill(colour, places, nodes, -1);
        Arrays.fill(colour, nodes + places, 2 * nodes, -1);
        refine();
    }

    private PairedColours(PairedColours other, long mostWork) {
        this.mostWork = mostWork;
        nodes = other.nodes;
        start = other.start;
        neighbour = other.neighbour;
        label = other.label;
        colour = other.colour.clone();
        colours = other.colours;
    }

    private void fill(PetriNet net, List<ArcTable> kinds) {
        int places = net.placeCount();
        int[] next = Arrays.copyOf(start, nodes);
        for (int kind = 0; kind < kinds.size(); kind++) {
            ArcTable arcs = kinds.get(kind);
            for (int t = 0; t < net.transitionCount(); t++) {
                for (int arc = arcs.from(t); arc < arcs.to(t); arc++) {
                    int place = arcs.node(arc);
                    long word = mixed(4L * arcs.weight(arc) + kind);
                    label[next[place]] = word;
                    neighbour[next[place]++] = places + t;
                    label[next[places + t]] = word;
                    neighbour[next[places + t]++] = place;
                }
            }
        }
    }

    PairedColours copy(long mostWorkOfCopy) {
        return new PairedColours(this, mostWorkOfCopy);
    }

    /** How many arcs were looked at since this copy was made; a node counts as some arcs. */
    long work() {
        return work;
    }

    /** Whether there was too much to do: colours may be too coarse. */
    boolean isCutOff() {
        return work >= mostWork;
    }

    /** The colour of a node of the net. */
    int ofNet(int node) {
        return colour[node];
    }

    /** The colour of a node of the copy. */
    int ofCopy(int node) {
        return colour[nodes + node];
    }

    int nodes() {
        return nodes;
    }

    /** Gives a node of the net and one of the copy a colour that no others have. */
    void pair(int ofNet, int ofCopy) {
        colour[ofNet] = colours;
        colour[nodes + ofCopy] = colours++;
    }

    /** Splits colours whose nodes have different neighbours, until there are none, or there was too much to do. */
    void refine() {
        int before = -1;
        while (colours != before && !isCutOff()) {
            before = colours;
            Map<Signature, Integer> known = new HashMap<>();
            int[] next = new int[2 * nodes];
            for (int node = 0; node < 2 * nodes; node++) {
                int own = node % nodes;
                int offset = node - own;
                long sum = 0;
                for (int i = start[own]; i < start[own + 1]; i++) {
                    sum += mixed(label[i] + colour[offset + neighbour[i]]);
                }
                next[node] = known.computeIfAbsent(new Signature(colour[node], sum), s -> known.size());
            }
            work += 2L * neighbour.length + 2L * NODE * nodes;
            colour = next;
            colours = known.size();
        }
    }

    private static long mixed(long value) {
        long spread = (value ^ (value >>> 31)) * 0x9E3779B97F4A7C15L;
        return (spread ^ (spread >>> 28)) * 0xBF58476D1CE4E5B9L ^ (spread >>> 32);
    }
}
