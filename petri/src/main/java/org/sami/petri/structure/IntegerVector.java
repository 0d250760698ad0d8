package org.sami.petri.structure;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntFunction;

/**
 * A vector of whole numbers of which most are 0: weights of places, counts of transitions. Immutable. Sums are exact: one that does not fit into a {@code long}
 * is an {@link ArithmeticException}, never a wrong number.
 */
public final class IntegerVector {
    /** The vector whose elements are all 0. */
    public static final IntegerVector ZERO = new IntegerVector(new int[0], new long[0]);

    private final int[] index;
    private final long[] value;

    private IntegerVector(int[] index, long[] value) {
        this.index = index;
        this.value = value;
    }

    /** The vector with these elements. */
    public static IntegerVector of(long[] elements) {
        int[] index = new int[elements.length];
        int size = 0;
        for (int i = 0; i < elements.length; i++) {
            if (elements[i] != 0) {
                index[size++] = i;
            }
        }
        int[] kept = Arrays.copyOf(index, size);
        return new IntegerVector(
                kept, Arrays.stream(kept).mapToLong(i -> elements[i]).toArray());
    }

    /** The vector with these elements at these indexes, which ascend; no element is 0. */
    static IntegerVector sorted(int[] index, long[] value) {
        return index.length == 0 ? ZERO : new IntegerVector(index, value);
    }

    /** The vector with one element that is not 0. */
    public static IntegerVector unit(int index, long value) {
        return value == 0 ? ZERO : new IntegerVector(new int[] {index}, new long[] {value});
    }

    /** The vector that is 1 at the members of a set. */
    public static IntegerVector ones(BitSet members) {
        int[] index = members.stream().toArray();
        long[] value = new long[index.length];
        Arrays.fill(value, 1);
        return new IntegerVector(index, value);
    }

    /** How many elements are not 0. */
    public int size() {
        return index.length;
    }

    public boolean isZero() {
        return index.length == 0;
    }

    /** Where the {@code i}-th element stands that is not 0. */
    public int indexAt(int i) {
        return index[i];
    }

    /** The {@code i}-th element that is not 0. */
    public long valueAt(int i) {
        return value[i];
    }

    /** The element at an index. */
    public long get(int at) {
        int found = Arrays.binarySearch(index, at);
        return found < 0 ? 0 : value[found];
    }

    /** Where the elements stand that are not 0. */
    public BitSet support() {
        BitSet support = new BitSet();
        for (int i : index) {
            support.set(i);
        }
        return support;
    }

    /** The sum of products with the tokens of a marking. */
    public long times(int[] marking) {
        long sum = 0;
        for (int i = 0; i < index.length; i++) {
            sum = Math.addExact(sum, Math.multiplyExact(value[i], (long) marking[index[i]]));
        }
        return sum;
    }

    /** The sum of products with another vector. */
    public long times(IntegerVector other) {
        long sum = 0;
        for (int i = 0, j = 0; i < index.length && j < other.index.length; ) {
            if (index[i] == other.index[j]) {
                sum = Math.addExact(sum, Math.multiplyExact(value[i++], other.value[j++]));
            } else if (index[i] < other.index[j]) {
                i++;
            } else {
                j++;
            }
        }
        return sum;
    }

    /** {@code factor} times this plus {@code otherFactor} times the other. */
    public IntegerVector combined(long factor, IntegerVector other, long otherFactor) {
        int[] indexes = new int[index.length + other.index.length];
        long[] values = new long[indexes.length];
        int size = 0;
        for (int i = 0, j = 0; i < index.length || j < other.index.length; ) {
            int here = i < index.length ? index[i] : Integer.MAX_VALUE;
            int there = j < other.index.length ? other.index[j] : Integer.MAX_VALUE;
            int at = Math.min(here, there);
            long sum = 0;
            if (here == at) {
                sum = Math.multiplyExact(factor, value[i++]);
            }
            if (there == at) {
                sum = Math.addExact(sum, Math.multiplyExact(otherFactor, other.value[j++]));
            }
            if (sum != 0) {
                indexes[size] = at;
                values[size++] = sum;
            }
        }
        return new IntegerVector(Arrays.copyOf(indexes, size), Arrays.copyOf(values, size));
    }

    /** This vector with each element divided, where all are multiples of the divisor. */
    IntegerVector dividedBy(long divisor) {
        return divisor == 1
                ? this
                : new IntegerVector(
                        index,
                        Arrays.stream(value).map(element -> element / divisor).toArray());
    }

    /** The greatest number that divides all elements; 0 where all are 0. */
    long greatestDivisor() {
        long divisor = 0;
        for (long element : value) {
            divisor = gcd(divisor, element);
            if (divisor == 1) {
                break;
            }
        }
        return divisor;
    }

    static long gcd(long first, long second) {
        long a = Math.absExact(first);
        long b = Math.absExact(second);
        while (b != 0) {
            long rest = a % b;
            a = b;
            b = rest;
        }
        return a;
    }

    /** The sum for people, each index by its name: {@code p + q + 2 r}; {@code 0} where all are 0. */
    public String words(IntFunction<String> names) {
        StringBuilder words = new StringBuilder();
        for (int i = 0; i < index.length; i++) {
            long size = Math.absExact(value[i]);
            String sign = value[i] < 0 ? "- " : "+ ";
            words.append(i > 0 ? " " + sign : sign.startsWith("-") ? "-" : "");
            words.append(size == 1 ? "" : size + " ").append(names.apply(index[i]));
        }
        return isZero() ? "0" : words.toString();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof IntegerVector that
                && Arrays.equals(index, that.index)
                && Arrays.equals(value, that.value);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(index) + Arrays.hashCode(value);
    }

    @Override
    public String toString() {
        return words(i -> "#" + i);
    }
}
