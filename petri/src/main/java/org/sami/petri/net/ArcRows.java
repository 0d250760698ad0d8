package org.sami.petri.net;

import java.util.Arrays;
import java.util.function.LongBinaryOperator;

/** Arcs of one kind in the order in which they were added; {@link #table} sorts them by transition and place and merges parallel ones. */
final class ArcRows {
    private int[] transition = new int[16];
    private int[] place = new int[16];
    private int[] weight = new int[16];
    private int size;

    /** How the ends of an arc are named in a fault. */
    @FunctionalInterface
    interface Words {
        String of(int transition, int place);
    }

    void add(int ofTransition, int ofPlace, int ofWeight) {
        if (size == transition.length) {
            int more = 2 * size;
            transition = Arrays.copyOf(transition, more);
            place = Arrays.copyOf(place, more);
            weight = Arrays.copyOf(weight, more);
        }
        transition[size] = ofTransition;
        place[size] = ofPlace;
        weight[size++] = ofWeight;
    }

    /** The arcs as a table. Refuses parallel arcs whose merged weight is no {@code int}. */
    ArcTable table(int rows, LongBinaryOperator merge, Words words) {
        int[] byRow = startsOfRows(rows);
        long[] sorted = sortedByPlace(byRow);
        int[] start = new int[rows + 1];
        int[] node = new int[size];
        int[] merged = new int[size];
        int count = 0;
        for (int row = 0; row < rows; row++) {
            start[row] = count;
            for (int i = byRow[row]; i < byRow[row + 1]; i++) {
                int other = (int) (sorted[i] >>> 32);
                int own = weight[(int) sorted[i]];
                if (count > start[row] && node[count - 1] == other) {
                    merged[count - 1] = checked(merge.applyAsLong(merged[count - 1], own), words, row, other);
                } else {
                    node[count] = other;
                    merged[count++] = own;
                }
            }
        }
        start[rows] = count;
        return new ArcTable(start, Arrays.copyOf(node, count), Arrays.copyOf(merged, count));
    }

    private int[] startsOfRows(int rows) {
        int[] starts = new int[rows + 1];
        for (int i = 0; i < size; i++) {
            starts[transition[i] + 1]++;
        }
        for (int row = 0; row < rows; row++) {
            starts[row + 1] += starts[row];
        }
        return starts;
    }

    /** Place and index of each arc, row after row, in the order of places. */
    private long[] sortedByPlace(int[] starts) {
        long[] sorted = new long[size];
        int[] next = Arrays.copyOf(starts, starts.length);
        for (int i = 0; i < size; i++) {
            sorted[next[transition[i]]++] = ((long) place[i] << 32) | i;
        }
        for (int row = 0; row + 1 < starts.length; row++) {
            Arrays.sort(sorted, starts[row], starts[row + 1]);
        }
        return sorted;
    }

    private static int checked(long weight, Words words, int row, int other) {
        if (weight > Integer.MAX_VALUE) {
            throw new IllegalArgumentException("the weights of the arcs between " + words.of(row, other) + " sum up to "
                    + weight + ", more than " + Integer.MAX_VALUE);
        }
        return (int) weight;
    }
}
