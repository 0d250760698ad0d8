package org.sami.petri.coverability;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;

/**
 * Numbered markings with the same unbounded places, in groups of the same marked places. The marked places of the groups stand in one array of 64 bits each (a place's
 * number modulo 64), so that groups which cannot matter are passed over without a look at their markings.
 */
final class MarkingBucket {
    private final MarkingOrder order;
    private final List<int[]> markings;
    private final Map<Long, Integer> groupOf = new HashMap<>();
    private long[] marked = new long[8];
    private int[][] members = new int[8][];
    private int[] sizes = new int[8];

    MarkingBucket(MarkingOrder order, List<int[]> markings) {
        this.order = order;
        this.markings = markings;
    }

    /** The number of a marking that covers one with these marked places; -1 where none does. */
    int covering(int[] marking, long markedPlaces) {
        int groups = groupOf.size();
        for (int group = 0; group < groups; group++) {
            if ((markedPlaces & ~marked[group]) == 0) {
                for (int i = 0; i < sizes[group]; i++) {
                    if (order.covers(markings.get(members[group][i]), marking)) {
                        return members[group][i];
                    }
                }
            }
        }
        return -1;
    }

    /** Removes the markings that one with these marked places covers. */
    void removeCovered(int[] marking, long markedPlaces, IntConsumer removed) {
        int groups = groupOf.size();
        for (int group = 0; group < groups; group++) {
            if ((marked[group] & ~markedPlaces) == 0) {
                int kept = 0;
                for (int i = 0; i < sizes[group]; i++) {
                    int member = members[group][i];
                    if (order.covers(marking, markings.get(member))) {
                        removed.accept(member);
                    } else {
                        members[group][kept++] = member;
                    }
                }
                sizes[group] = kept;
            }
        }
    }

    void add(int number, long markedPlaces) {
        int group = groupOf.computeIfAbsent(markedPlaces, this::newGroup);
        if (sizes[group] == members[group].length) {
            members[group] = Arrays.copyOf(members[group], 2 * sizes[group]);
        }
        members[group][sizes[group]++] = number;
    }

    private int newGroup(long markedPlaces) {
        int group = groupOf.size();
        if (group == marked.length) {
            marked = Arrays.copyOf(marked, 2 * group);
            members = Arrays.copyOf(members, 2 * group);
            sizes = Arrays.copyOf(sizes, 2 * group);
        }
        marked[group] = markedPlaces;
        members[group] = new int[2];
        return group;
    }
}
