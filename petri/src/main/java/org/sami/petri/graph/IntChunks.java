package org.sami.petri.graph;

import java.util.Arrays;

/** A list of ints in chunks, so that it grows without copying what it holds; only the first chunk grows by copying. */
final class IntChunks {
    private static final int BITS = 14;
    private static final int CHUNK = 1 << BITS;
    private static final int FIRST = 64;

    private int[][] chunks = {new int[FIRST]};
    private int used = 1;
    private long size;

    long size() {
        return size;
    }

    int get(long index) {
        return chunks[(int) (index >>> BITS)][(int) index & (CHUNK - 1)];
    }

    void add(int value) {
        int chunk = (int) (size >>> BITS);
        int at = (int) size & (CHUNK - 1);
        if (chunk == used) {
            if (used == chunks.length) {
                chunks = Arrays.copyOf(chunks, 2 * used);
            }
            chunks[used++] = new int[CHUNK];
        } else if (at == chunks[chunk].length) {
            chunks[chunk] = Arrays.copyOf(chunks[chunk], 2 * at);
        }
        chunks[chunk][at] = value;
        size++;
    }

    /** How many elements it has room for before another array is needed. */
    long capacity() {
        return (used - 1L) * CHUNK + chunks[used - 1].length;
    }

    /** By how many bytes its arrays of elements grow when so many are added. */
    long bytesToAdd(long count) {
        long needed = size + count;
        long capacity = capacity();
        while (capacity < needed) {
            capacity = capacity < CHUNK ? 2 * capacity : (needed + CHUNK - 1) / CHUNK * CHUNK;
        }
        return Integer.BYTES * (capacity - capacity());
    }

    /** The bytes of its arrays. */
    long bytes() {
        long lastChunk = chunks[used - 1].length;
        return Integer.BYTES * ((used - 1L) * CHUNK + lastChunk) + Long.BYTES * (long) chunks.length;
    }
}
