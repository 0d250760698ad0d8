package org.sami.petri.graph;

import java.util.Arrays;

/**
 * The slots of a hash table, in arrays of at most 64 KB, so that a table grows without a second one beside it and a heap that is nearly full has room for it. For one
 * thread.
 */
final class SlotChunks {
    private static final int BITS = 14;
    private static final int CHUNK = 1 << BITS;

    private int[][] chunks = {};
    private int length;

    /** So many slots, from 1, each of them 0. */
    SlotChunks(int length) {
        resize(length);
    }

    int length() {
        return length;
    }

    int get(int slot) {
        return chunks[slot >>> BITS][slot & (CHUNK - 1)];
    }

    void set(int slot, int value) {
        chunks[slot >>> BITS][slot & (CHUNK - 1)] = value;
    }

    void clear() {
        for (int[] chunk : chunks) {
            Arrays.fill(chunk, 0);
        }
    }

    /** Clears the slots and has so many of them from now on; full arrays are used again. */
    void resize(int size) {
        clear();
        int[][] old = chunks;
        chunks = new int[(size + CHUNK - 1) >>> BITS][];
        for (int i = 0; i < chunks.length; i++) {
            int own = Math.min(CHUNK, size - (i << BITS));
            chunks[i] = i < old.length && old[i].length == own ? old[i] : new int[own];
        }
        length = size;
    }

    long bytes() {
        return (long) Integer.BYTES * length;
    }
}
