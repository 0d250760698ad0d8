package org.sami.petri.coverability;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;

/**
 * Numbered markings none of which covers another. They are kept in groups of the same marked places and the same unbounded places, each as 64 bits (a place's number
 * modulo 64): most groups are passed over without a look at their markings.
 */
final class MaximalMarkings {
    private final MarkingOrder order;
    private final List<int[]> markings;
    private final Map<Signature, Group> bySignature = new HashMap<>();
    private final List<Group> groups = new ArrayList<>();

    /** What markings of a group share. */
    private record Signature(long marked, long unbounded, int exact) {
        boolean mayBeCoveredBy(Signature large) {
            return exact == large.exact && (marked & ~large.marked) == 0 && (unbounded & ~large.unbounded) == 0;
        }
    }

    private static final class Group {
        private final Signature signature;
        private int[] members = new int[4];
        private int size;

        private Group(Signature signature) {
            this.signature = signature;
        }

        private void add(int member) {
            if (size == members.length) {
                members = Arrays.copyOf(members, 2 * size);
            }
            members[size++] = member;
        }
    }

    /** None yet; {@code markings} has the marking of each number. */
    MaximalMarkings(MarkingOrder order, List<int[]> markings) {
        this.order = order;
        this.markings = markings;
    }

    /** The number of one that covers a marking; -1 where none does. */
    int covering(int[] marking) {
        Signature signature = signature(marking);
        for (Group group : groups) {
            if (signature.mayBeCoveredBy(group.signature)) {
                for (int i = 0; i < group.size; i++) {
                    if (order.covers(markings.get(group.members[i]), marking)) {
                        return group.members[i];
                    }
                }
            }
        }
        return -1;
    }

    /** Adds a marking that none covers, and removes those that it covers. */
    void add(int number, IntConsumer removed) {
        int[] marking = markings.get(number);
        Signature signature = signature(marking);
        for (Group group : groups) {
            if (group.signature.mayBeCoveredBy(signature)) {
                removeCovered(group, marking, removed);
            }
        }
        bySignature.computeIfAbsent(signature, this::newGroup).add(number);
    }

    private Group newGroup(Signature signature) {
        Group group = new Group(signature);
        groups.add(group);
        return group;
    }

    private void removeCovered(Group group, int[] marking, IntConsumer removed) {
        int kept = 0;
        for (int i = 0; i < group.size; i++) {
            int member = group.members[i];
            if (order.covers(marking, markings.get(member))) {
                removed.accept(member);
            } else {
                group.members[kept++] = member;
            }
        }
        group.size = kept;
    }

    private Signature signature(int[] marking) {
        long marked = 0;
        long unbounded = 0;
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] > 0) {
                marked |= 1L << place; // of the place's number modulo 64
                if (marking[place] == Omega.OMEGA) {
                    unbounded |= 1L << place;
                }
            }
        }
        return new Signature(marked, unbounded, order.hashOfExactPlaces(marking));
    }
}
