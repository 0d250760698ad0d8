package org.sami.petri.structure;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;

/**
 * The minimal closed sets of places: minimal siphons or minimal traps. One is found by taking places away from the greatest closed set while a closed set is left. Any
 * other lacks a place of it; the search goes on once for each place {@code p}, with that place forbidden and those before it required, so no set is found twice.
 *
 * <p>Source: Cordone, Ferrarini and Piroddi, "Enumeration algorithms for minimal siphons in Petri nets based on place constraints", IEEE Transactions on Systems, Man
 * and Cybernetics A 35(6), 2005.
 */
public final class MinimalClosedSets {
    private final ClosedPlaces closed;
    private final StructureLimits limits;
    private final Deque<Problem> open = new ArrayDeque<>();
    private final List<BitSet> found = new ArrayList<>();

    /** Closed sets within the allowed places that contain the required ones. */
    private record Problem(BitSet allowed, BitSet required) {}

    /**
     * Minimal sets.
     *
     * @param complete whether these are all; each is minimal in any case
     */
    public record Result(List<BitSet> sets, boolean complete) {
        public Result {
            sets = List.copyOf(sets);
        }
    }

    private MinimalClosedSets(ClosedPlaces closed, StructureLimits limits) {
        this.closed = closed;
        this.limits = limits;
    }

    /** All minimal closed sets that are not empty. */
    public static Result of(ClosedPlaces closed, StructureLimits limits) {
        return new MinimalClosedSets(closed, limits).search();
    }

    private Result search() {
        BitSet all = new BitSet();
        all.set(0, closed.places());
        open.push(new Problem(all, new BitSet()));
        for (int looked = 0; !open.isEmpty(); looked++) {
            if (looked >= limits.sets() || limits.cancelled().getAsBoolean()) {
                return new Result(found, false);
            }
            solve(open.pop());
        }
        return new Result(found, !limits.cancelled().getAsBoolean());
    }

    private void solve(Problem problem) {
        BitSet greatest = closed.greatestWithin(problem.allowed());
        if (greatest.isEmpty() || !contains(greatest, problem.required())) {
            return;
        }
        BitSet set = reduced(greatest, problem.required());
        if (limits.cancelled().getAsBoolean()) {
            return; // the set may not be reduced
        }
        if (isMinimal(set)) {
            found.add(set);
        }
        BitSet required = (BitSet) problem.required().clone();
        for (int place = set.nextSetBit(0); place >= 0; place = set.nextSetBit(place + 1)) {
            if (!problem.required().get(place)) {
                BitSet allowed = (BitSet) greatest.clone();
                allowed.clear(place);
                open.push(new Problem(allowed, (BitSet) required.clone()));
                required.set(place);
            }
        }
    }

    /** A closed subset that contains the required places and has no smaller one that does; never empty. */
    private BitSet reduced(BitSet start, BitSet required) {
        BitSet set = start;
        for (int place = start.nextSetBit(0); place >= 0; place = start.nextSetBit(place + 1)) {
            if (set.get(place) && !required.get(place) && !limits.cancelled().getAsBoolean()) {
                BitSet smaller = without(set, place);
                if (!smaller.isEmpty() && contains(smaller, required)) {
                    set = smaller;
                }
            }
        }
        return set;
    }

    private boolean isMinimal(BitSet set) {
        return set.stream()
                .allMatch(place -> !limits.cancelled().getAsBoolean()
                        && without(set, place).isEmpty());
    }

    private BitSet without(BitSet set, int place) {
        BitSet rest = (BitSet) set.clone();
        rest.clear(place);
        return closed.greatestWithin(rest);
    }

    private static boolean contains(BitSet set, BitSet part) {
        BitSet missing = (BitSet) part.clone();
        missing.andNot(set);
        return missing.isEmpty();
    }
}
