package org.sami.petri.graph;

import java.util.Arrays;

/** A list of longs in chunks, so that it grows without copying what it holds; only the first chunk grows by copying. */
final class LongChunks {
    private static final int BITS = 13;
    private static final int CHUNK = 1 << BITS;
    private static final int FIRST = 64;

    private long[][] chunks = {new long[FIRST]};
    private int used = 1;
    private long size;

    long size() {
        return size;
    }

    long get(long index) {
        return chunks[(int) (index >>> BITS)][(int) index & (CHUNK - 1)];
    }

    void set(long index, long value) {
        chunks[(int) (index >>> BITS)][(int) index & (CHUNK - 1)] = value;
    }

    void add(long value) {
        int chunk = (int) (size >>> BITS);
        int at = (int) size & (CHUNK - 1);
        if (chunk == used) {
            if (used == chunks.length) {
                chunks = Arrays.copyOf(chunks, 2 * used);
            }
            chunks[used++] = new long[CHUNK];
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
        return Long.BYTES * (capacity - capacity());
    }

    /** The bytes of its arrays. */
    long bytes() {
        long lastChunk = chunks[used - 1].length;
        return Long.BYTES * ((used - 1L) * CHUNK + lastChunk + chunks.length);
    }
}
