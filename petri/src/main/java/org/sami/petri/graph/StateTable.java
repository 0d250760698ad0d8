package org.sami.petri.graph;

/**
 * The set of states found so far: packed states one after the other, and a hash table of their numbers (open addressing, linear probing). No object a state. The
 * table may have any number of slots, so that it can fill what is left of a memory. For one thread.
 */
final class StateTable {
    /** At most this part of the slots is used: 3 of 5. The one who adds states makes the table larger. */
    private static final int LOAD_OF = 5;

    private static final int LOAD = 3;

    private static final int LEAST_SLOTS = 64;

    /** The most slots of a table: an array of Java has at most about 2^31 elements. */
    static final int MOST_SLOTS = 1 << 30;

    private final LongChunks states = new LongChunks();
    private int words;
    private final SlotChunks slots = new SlotChunks(LEAST_SLOTS);
    private int count;

    StateTable(int words) {
        this.words = words;
    }

    int count() {
        return count;
    }

    long bytes() {
        return states.bytes() + slots.bytes();
    }

    /** By how many bytes the packed states grow with another one; the slots are not counted. */
    long bytesToAdd() {
        return states.bytesToAdd(words);
    }

    /** By how many bytes the packed states grow when each of them has so many words. */
    long bytesToRepack(int wider) {
        return states.bytesToAdd((long) count * (wider - words));
    }

    /** Whether there can be another state. */
    boolean canGrow() {
        return !isFull() || slots.length() < MOST_SLOTS;
    }

    /** The number of states at which slots or packed states need a larger array. */
    int nextGrowth() {
        long full = ((long) slots.length() * LOAD + LOAD_OF - 1) / LOAD_OF;
        return (int) Math.min(full, states.capacity() / words);
    }

    int slots() {
        return slots.length();
    }

    /** Whether another state needs more slots. */
    boolean isFull() {
        return (long) count * LOAD_OF >= (long) slots.length() * LOAD;
    }

    void load(int state, long[] into) {
        long at = (long) state * words;
        for (int w = 0; w < words; w++) {
            into[w] = states.get(at + w);
        }
    }

    /** The number of a state; -1 where it is not in the set. */
    int find(long[] state) {
        return slots.get(slotOf(state)) - 1;
    }

    /** The number of a state, which is added where it is not in the set yet; {@link #count} tells. The table must not be full. */
    int add(long[] state) {
        int slot = slotOf(state);
        if (slots.get(slot) != 0) {
            return slots.get(slot) - 1;
        }
        for (int w = 0; w < words; w++) {
            states.add(state[w]);
        }
        slots.set(slot, ++count);
        return count - 1;
    }

    /** The slot of a state, or the free one in which it would be. */
    private int slotOf(long[] state) {
        int slot = firstSlot(state);
        while (slots.get(slot) != 0 && !isAt(slots.get(slot) - 1, state)) {
            slot = following(slot);
        }
        return slot;
    }

    /** The slot at which the search for a state begins: the upper half of its hash as a fraction of all slots. */
    private int firstSlot(long[] state) {
        return (int) (((hash(state) >>> Integer.SIZE) * slots.length()) >>> Integer.SIZE);
    }

    private int following(int slot) {
        return slot + 1 == slots.length() ? 0 : slot + 1;
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

    /** Gives the table so many slots, more than there are states. */
    void grow(int size) {
        slots.resize(size);
        enterAll();
    }

    private void enterAll() {
        long[] state = new long[words];
        for (int number = 0; number < count; number++) {
            load(number, state);
            int slot = firstSlot(state);
            while (slots.get(slot) != 0) {
                slot = following(slot);
            }
            slots.set(slot, number + 1);
        }
    }

    /** Packs all states again, each in its place, in another layout of as many words or more, in which each of them fits; their numbers stay. */
    void repack(StateLayout from, StateLayout to) {
        long[] old = new long[words];
        long[] packed = new long[to.words()];
        int[] marking = new int[from.places()];
        for (long more = (long) count * (to.words() - words); more > 0; more--) {
            states.add(0);
        }
        for (int number = count - 1;
                number >= 0;
                number--) { // from the last on: none is written over before it is read
            load(number, old);
            from.unpack(old, marking);
            to.pack(marking, packed);
            long start = (long) number * packed.length;
            for (int w = 0; w < packed.length; w++) {
                states.set(start + w, packed[w]);
            }
        }
        words = packed.length;
        slots.clear();
        enterAll();
    }
}
