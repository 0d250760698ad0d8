package org.sami.petri.pnml;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntUnaryOperator;

/** A multiset of colours of one sort. Immutable. Its operations throw an {@link ArithmeticException} where a count exceeds a long. */
record ColourBag(ColourSort sort, Map<Integer, Long> counts) {
    static ColourBag of(ColourSort sort, int colour) {
        return new ColourBag(sort, Map.of(colour, 1L));
    }

    /** Each colour of a sort once. */
    static ColourBag all(ColourSort sort) {
        Map<Integer, Long> counts = new TreeMap<>();
        for (int colour = 0; colour < sort.size(); colour++) {
            counts.put(colour, 1L);
        }
        return new ColourBag(sort, counts);
    }

    /** Its own colours and so many times those of another one; how many of a colour there are may be below 0. */
    ColourBag plus(ColourBag other, long times) {
        Map<Integer, Long> sums = new TreeMap<>(counts);
        other.counts.forEach((colour, count) -> sums.merge(colour, Math.multiplyExact(times, count), Math::addExact));
        return new ColourBag(sort, sums);
    }

    ColourBag times(long factor) {
        Map<Integer, Long> products = new TreeMap<>();
        counts.forEach((colour, count) -> products.put(colour, Math.multiplyExact(factor, count)));
        return new ColourBag(sort, products);
    }

    /** The pairs of its own colours and those of another one. */
    ColourBag with(ColourBag other) {
        int size = (int) other.sort.size();
        Map<Integer, Long> products = new TreeMap<>();
        counts.forEach((colour, count) -> other.counts.forEach(
                (last, many) -> products.merge(colour * size + last, Math.multiplyExact(count, many), Math::addExact)));
        return new ColourBag(ColourSort.product(sort, other.sort), products);
    }

    ColourBag changed(IntUnaryOperator change) {
        Map<Integer, Long> images = new TreeMap<>();
        counts.forEach((colour, count) -> images.merge(change.applyAsInt(colour), count, Math::addExact));
        return new ColourBag(sort, images);
    }
}
