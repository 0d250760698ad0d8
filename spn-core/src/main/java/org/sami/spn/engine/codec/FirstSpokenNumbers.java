package org.sami.spn.engine.codec;

/** Numbers ids, which are greater than 0, from 1 on, in the order in which they are first spoken of. A hash table without objects. */
final class FirstSpokenNumbers {
    private long[] ids = new long[32]; // 0 = free; a power of two, at most half of it in use
    private int[] numbers = new int[32];
    private int last;

    /** The number of an id; it gets the next one where it has none. */
    long of(long id) {
        int at = find(id);
        if (ids[at] == 0) {
            if (++last * 2 > ids.length) {
                grow();
                at = find(id);
            }
            ids[at] = id;
            numbers[at] = last;
        }
        return numbers[at];
    }

    private void grow() {
        long[] oldIds = ids;
        int[] oldNumbers = numbers;
        ids = new long[oldIds.length * 2];
        numbers = new int[oldIds.length * 2];
        for (int i = 0; i < oldIds.length; i++) {
            if (oldIds[i] != 0) {
                int at = find(oldIds[i]);
                ids[at] = oldIds[i];
                numbers[at] = oldNumbers[i];
            }
        }
    }

    private int find(long id) {
        int mask = ids.length - 1;
        int at = (int) id & mask;
        while (ids[at] != 0 && ids[at] != id) {
            at = at + 1 & mask;
        }
        return at;
    }
}
