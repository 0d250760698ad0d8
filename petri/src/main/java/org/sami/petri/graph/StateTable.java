package org.sami.petri.graph;

/**
 * The set of states found so far: packed states one after the other, and a hash table of their numbers (open addressing, linear probing). No object a state. For
 * one thread.
 */
final class StateTable {
    /** At most this part of the slots is used: 3 of 5. */
    private static final int LOAD_OF = 5;

    private static final int LOAD = 3;

    /** After so many new states the memory is looked at. */
    private static final int LOOK_EVERY = 8192;

    private static final int LEAST_BITS = 6;

    /** The most bits of a table: an array of Java has at most about 2^31 elements. */
    private static final int MOST_BITS = 30;

    private final int words;
    private final LongChunks states = new LongChunks();
    private int[] slots = new int[1 << LEAST_BITS];
    private int bits = LEAST_BITS;
    private int count;

    StateTable(int words) {
        this.words = words;
    }

    int count() {
        return count;
    }

    long bytes() {
        return states.bytes() + (long) Integer.BYTES * slots.length;
    }

    /** How many bytes the next new state needs at most, at once: those of a new table where this one is full. */
    long bytesToGrow() {
        return isFull() ? 2L * Integer.BYTES * slots.length : 0;
    }

    /** Whether there can be another state. */
    boolean canGrow() {
        return !isFull() || bits < MOST_BITS;
    }

    /** The number of states at which the table grows, but soon enough to look at the memory now and then. */
    int nextGrowth() {
        long full = ((long) slots.length * LOAD + LOAD_OF - 1) / LOAD_OF;
        return (int) Math.min(full > count ? full : Integer.MAX_VALUE, count + LOOK_EVERY);
    }

    private boolean isFull() {
        return (long) count * LOAD_OF >= (long) slots.length * LOAD;
    }

    void load(int state, long[] into) {
        long at = (long) state * words;
        for (int w = 0; w < words; w++) {
            into[w] = states.get(at + w);
        }
    }

    /** The number of a state; -1 where it is not in the set. */
    int find(long[] state) {
        return slots[slotOf(state)] - 1;
    }

    /** The number of a state, which is added where it is not in the set yet; {@link #count} tells. */
    int add(long[] state) {
        int slot = slotOf(state);
        if (slots[slot] != 0) {
            return slots[slot] - 1;
        }
        if (isFull()) {
            grow();
            slot = slotOf(state);
        }
        for (int w = 0; w < words; w++) {
            states.add(state[w]);
        }
        slots[slot] = ++count;
        return count - 1;
    }

    /** The slot of a state, or the free one in which it would be. */
    private int slotOf(long[] state) {
        int mask = slots.length - 1;
        int slot = (int) (hash(state) >>> (Long.SIZE - bits));
        while (slots[slot] != 0 && !isAt(slots[slot] - 1, state)) {
            slot = (slot + 1) & mask;
        }
        return slot;
    }

    private boolean isAt(int number, long[] state) {
        if (words == 1) {
            return states.get(number) == state[0];
        }
        long at = (long) number * words;
        for (int w = 0; w < words; w++) {
            if (states.get(at + w) != state[w]) {
                return false;
            }
        }
        return true;
    }

    private long hash(long[] state) {
        long h = state[0];
        for (int w = 1; w < words; w++) {
            h = mixed(h) + state[w];
        }
        return mixed(h);
    }

    /** Spreads each bit over the upper ones, from which slots are taken: the finalizer of a multiplicative hash. */
    private static long mixed(long h) {
        long spread = (h ^ (h >>> 32)) * 0x9E3779B97F4A7C15L;
        return (spread ^ (spread >>> 29)) * 0xBF58476D1CE4E5B9L;
    }

    private void grow() {
        bits++;
        slots = new int[1 << bits];
        int mask = slots.length - 1;
        long[] state = new long[words];
        for (int number = 0; number < count; number++) {
            load(number, state);
            int slot = (int) (hash(state) >>> (Long.SIZE - bits));
            while (slots[slot] != 0) {
                slot = (slot + 1) & mask;
            }
            slots[slot] = number + 1;
        }
    }

    /** The same states with the same numbers in another layout, in which each of them fits. */
    StateTable repacked(StateLayout from, StateLayout to) {
        StateTable table = new StateTable(to.words());
        long[] old = new long[words];
        long[] packed = new long[to.words()];
        int[] marking = new int[from.places()];
        for (int number = 0; number < count; number++) {
            load(number, old);
            from.unpack(old, marking);
            to.pack(marking, packed);
            table.add(packed);
        }
        return table;
    }
}
