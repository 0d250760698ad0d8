package org.sami.crw.service.allocation;

import java.util.List;

/** Puts work where it makes a path least longer, one after another; equally cheap places: the first boat's, the first place. */
final class CheapestInsertion {
    private CheapestInsertion() {}

    /**
     * Inserts the work of a problem from an index on.
     *
     * @param shares the indices of each boat's work so far, in its order; changed
     */
    static void insert(int from, AllocationProblem problem, TravelCosts legs, List<List<Integer>> shares) {
        for (int work = from; work < problem.work().size(); work++) {
            insertOne(work, legs, shares);
        }
    }

    private static void insertOne(int work, TravelCosts legs, List<List<Integer>> shares) {
        double least = Double.POSITIVE_INFINITY;
        int bestBoat = -1;
        int bestBefore = 0;
        for (int boat = 0; boat < shares.size(); boat++) {
            List<Integer> share = shares.get(boat);
            boolean can = legs.canDo(boat, work);
            for (int before = 0; can && before <= share.size(); before++) {
                int previous = before == 0 ? -1 : share.get(before - 1);
                double cost = legs.leg(boat, previous, work);
                if (before < share.size()) {
                    cost += legs.between(work, share.get(before)) - legs.leg(boat, previous, share.get(before));
                }
                if (bestBoat < 0 || cost < least) {
                    least = cost;
                    bestBoat = boat;
                    bestBefore = before;
                }
            }
        }
        shares.get(bestBoat).add(bestBefore, work);
    }
}
