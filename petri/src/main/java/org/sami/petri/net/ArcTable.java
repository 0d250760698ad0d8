package org.sami.petri.net;

import java.util.Arrays;

/**
 * The arcs of one kind, by row: row {@code r} has the arcs {@code from(r)} (inclusive) to {@code to(r)} (exclusive), each with the node at its other end and a
 * weight, in ascending order of that node. In a {@link PetriNet} rows are transitions and the other ends are places; {@link #transposed} turns that round.
 * Immutable.
 */
public final class ArcTable {
    private final int[] start;
    private final int[] node;
    private final int[] weight;

    ArcTable(int[] start, int[] node, int[] weight) {
        this.start = start;
        this.node = node;
        this.weight = weight;
    }

    /** How many rows there are. */
    public int rows() {
        return start.length - 1;
    }

    /** How many arcs there are in all rows. */
    public int size() {
        return node.length;
    }

    /** The first arc of a row. */
    public int from(int row) {
        return start[row];
    }

    /** The arc after the last one of a row. */
    public int to(int row) {
        return start[row + 1];
    }

    /** Whether a row has no arc. */
    public boolean isEmpty(int row) {
        return start[row] == start[row + 1];
    }

    /** The node at the other end of an arc. */
    public int node(int arc) {
        return node[arc];
    }

    /** The weight of an arc: 1 or more. */
    public int weight(int arc) {
        return weight[arc];
    }

    /** The weight of the arc between a row and a node; 0 where there is none. */
    public int weight(int row, int other) {
        int arc = Arrays.binarySearch(node, start[row], start[row + 1], other);
        return arc < 0 ? 0 : weight[arc];
    }

    /**
     * The same arcs seen from their other ends.
     *
     * @param nodes how many nodes there are at the other ends
     */
    public ArcTable transposed(int nodes) {
        int[] starts = new int[nodes + 1];
        for (int other : node) {
            starts[other + 1]++;
        }
        for (int i = 0; i < nodes; i++) {
            starts[i + 1] += starts[i];
        }
        int[] next = Arrays.copyOf(starts, nodes);
        int[] rowOf = new int[node.length];
        int[] weights = new int[node.length];
        for (int row = 0; row < rows(); row++) {
            for (int arc = start[row]; arc < start[row + 1]; arc++) {
                int at = next[node[arc]]++;
                rowOf[at] = row;
                weights[at] = weight[arc];
            }
        }
        return new ArcTable(starts, rowOf, weights);
    }
}
