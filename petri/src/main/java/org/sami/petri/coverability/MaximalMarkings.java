package org.sami.petri.coverability;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;

/** Numbered markings none of which covers another, by their unbounded places and what they have in places with exact numbers. */
final class MaximalMarkings {
    private final MarkingOrder order;
    private final List<int[]> markings;
    private final Map<Kind, MarkingBucket> buckets = new LinkedHashMap<>();

    /** What markings share: unbounded places as 64 bits (a place's number modulo 64), and a hash of the exact numbers. */
    private record Kind(long unbounded, int exact) {
        boolean mayBeCoveredBy(Kind large) {
            return exact == large.exact && (unbounded & ~large.unbounded) == 0;
        }
    }

    /** None yet; {@code markings} has the marking of each number. */
    MaximalMarkings(MarkingOrder order, List<int[]> markings) {
        this.order = order;
        this.markings = markings;
    }

    /** The number of one that covers a marking; -1 where none does. */
    int covering(int[] marking) {
        Kind kind = kind(marking);
        long marked = marked(marking);
        for (Map.Entry<Kind, MarkingBucket> bucket : buckets.entrySet()) {
            if (kind.mayBeCoveredBy(bucket.getKey())) {
                int covering = bucket.getValue().covering(marking, marked);
                if (covering >= 0) {
                    return covering;
                }
            }
        }
        return -1;
    }

    /** Adds a marking that none covers, and removes those that it covers. */
    void add(int number, IntConsumer removed) {
        int[] marking = markings.get(number);
        Kind kind = kind(marking);
        long marked = marked(marking);
        buckets.forEach((of, bucket) -> {
            if (of.mayBeCoveredBy(kind)) {
                bucket.removeCovered(marking, marked, removed);
            }
        });
        buckets.computeIfAbsent(kind, of -> new MarkingBucket(order, markings)).add(number, marked);
    }

    private Kind kind(int[] marking) {
        long unbounded = 0;
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] == Omega.OMEGA) {
                unbounded |= 1L << place; // of the place's number modulo 64
            }
        }
        return new Kind(unbounded, order.hashOfExactPlaces(marking));
    }

    private static long marked(int[] marking) {
        long marked = 0;
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] > 0) {
                marked |= 1L << place;
            }
        }
        return marked;
    }
}
