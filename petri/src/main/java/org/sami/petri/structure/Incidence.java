package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * What firings add to a marking: column {@code t} is what transition {@code t} produces less what it consumes. Each place that a reset arc empties has a column
 * more, which removes one token of it. So every reachable marking is the initial one plus a sum of columns, none of them fewer than 0 times: where a reset removes
 * {@code k} tokens, the place's column counts {@code k} times. Inhibitor arcs are left out; they allow fewer sums, never others.
 *
 * <p>Source: Murata, "Petri nets: properties, analysis and applications", Proceedings of the IEEE 77(4), 1989, section IV.B; the columns for resets are ours.
 */
final class Incidence {
    private final List<IntegerVector> columns;
    private final List<IntegerVector> rows;

    private Incidence(List<IntegerVector> columns, int places) {
        this.columns = columns;
        this.rows = transposed(columns, places);
    }

    static Incidence of(PetriNet net) {
        List<IntegerVector> columns = new ArrayList<>();
        for (int transition = 0; transition < net.transitionCount(); transition++) {
            columns.add(vector(net.produced(), transition).combined(1, vector(net.consumed(), transition), -1));
        }
        ArcTable emptied = net.resets().transposed(net.placeCount());
        for (int place = 0; place < net.placeCount(); place++) {
            if (!emptied.isEmpty(place)) {
                columns.add(IntegerVector.unit(place, -1));
            }
        }
        return new Incidence(columns, net.placeCount());
    }

    /** One vector of places a column: first those of the transitions, then those of places that are reset. */
    List<IntegerVector> columns() {
        return columns;
    }

    /** One vector of columns a place. */
    List<IntegerVector> rows() {
        return rows;
    }

    /** Whether no firing makes a weighted sum of tokens larger. */
    boolean neverGrows(IntegerVector weights) {
        return columns.stream().allMatch(column -> weights.times(column) <= 0);
    }

    /** Whether no firing changes a weighted sum of tokens. */
    boolean neverChanges(IntegerVector weights) {
        return columns.stream().allMatch(column -> weights.times(column) == 0);
    }

    private static IntegerVector vector(ArcTable arcs, int row) {
        IntegerVector vector = IntegerVector.ZERO;
        int size = arcs.to(row) - arcs.from(row);
        if (size > 0) {
            int[] index = new int[size];
            long[] value = new long[size];
            for (int i = 0; i < size; i++) {
                index[i] = arcs.node(arcs.from(row) + i);
                value[i] = arcs.weight(arcs.from(row) + i);
            }
            vector = IntegerVector.sorted(index, value);
        }
        return vector;
    }

    /** The vectors read the other way: element {@code j} of vector {@code i} becomes element {@code i} of vector {@code j}. */
    static List<IntegerVector> transposed(List<IntegerVector> vectors, int count) {
        int[] sizes = new int[count];
        for (IntegerVector vector : vectors) {
            for (int i = 0; i < vector.size(); i++) {
                sizes[vector.indexAt(i)]++;
            }
        }
        int[][] index = new int[count][];
        long[][] value = new long[count][];
        for (int i = 0; i < count; i++) {
            index[i] = new int[sizes[i]];
            value[i] = new long[sizes[i]];
        }
        for (int row = vectors.size() - 1; row >= 0; row--) {
            IntegerVector vector = vectors.get(row);
            for (int i = 0; i < vector.size(); i++) {
                int at = --sizes[vector.indexAt(i)];
                index[vector.indexAt(i)][at] = row;
                value[vector.indexAt(i)][at] = vector.valueAt(i);
            }
        }
        List<IntegerVector> turned = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            turned.add(IntegerVector.sorted(index[i], value[i]));
        }
        return turned;
    }
}
