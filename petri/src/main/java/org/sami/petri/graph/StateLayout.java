package org.sami.petri.graph;

/**
 * How markings are packed: each place has a field of some bits in one of the words of a state. Fields do not cross words, and a field of {@code b} bits holds up
 * to {@code 2^b - 1} tokens. Packing is linear: while no field overflows, the sum of two packed markings is the packed sum. Immutable.
 */
final class StateLayout {
    /** As many bits as the largest number of tokens has. */
    static final int MOST_BITS = 31;

    private final int[] bits;
    private final int[] word;
    private final int[] shift;
    private final int words;

    /** For each word its first place, and the number of places at the end. */
    private final int[] firstPlace;

    /** A layout with these bits for each place: from 1 to {@link #MOST_BITS}. */
    StateLayout(int[] bits) {
        this.bits = bits;
        word = new int[bits.length];
        shift = new int[bits.length];
        int at = 0;
        int used = 0;
        for (int place = 0; place < bits.length; place++) {
            if (used + bits[place] > Long.SIZE) {
                at++;
                used = 0;
            }
            word[place] = at;
            shift[place] = used;
            used += bits[place];
        }
        words = at + 1;
        firstPlace = new int[words + 1];
        for (int place = 0; place < bits.length; place++) {
            firstPlace[word[place] + 1] = place + 1;
        }
    }

    /** How many bits hold a number of tokens: at least 1. */
    static int bitsFor(int tokens) {
        return Math.max(1, Integer.SIZE - Integer.numberOfLeadingZeros(tokens));
    }

    /** How many words a state has. */
    int words() {
        return words;
    }

    int places() {
        return bits.length;
    }

    int bits(int place) {
        return bits[place];
    }

    int word(int place) {
        return word[place];
    }

    int shift(int place) {
        return shift[place];
    }

    /** The most tokens that the field of a place holds. */
    int most(int place) {
        return (int) ((1L << bits[place]) - 1);
    }

    void unpack(long[] state, int[] marking) {
        for (int w = 0; w < words; w++) {
            long fields = state[w];
            for (int place = firstPlace[w]; place < firstPlace[w + 1]; place++) {
                marking[place] = (int) (fields >>> shift[place]) & most(place);
            }
        }
    }

    /** Packs a marking; whether each place has room for its tokens. Where one has not, the state is of no use. */
    boolean pack(int[] marking, long[] state) {
        int excess = 0;
        for (int w = 0; w < words; w++) {
            long fields = 0;
            for (int place = firstPlace[w]; place < firstPlace[w + 1]; place++) {
                excess |= marking[place] >>> bits[place];
                fields |= (long) marking[place] << shift[place];
            }
            state[w] = fields;
        }
        return excess == 0;
    }
}
