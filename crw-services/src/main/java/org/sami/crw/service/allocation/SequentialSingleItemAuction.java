package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * Sequential single-item auction with nearest-neighbour insertion (thesis 7.0.3). Locations are auctioned in the given order. A boat bids the length
 * of its whole path with the location added to those it has won: the nearest-neighbour path from its position. The lowest bid wins; among equal bids,
 * that of the boat named first.
 *
 * <p>A bid is the length of the whole path and not the increase, so boats with long paths lose and the work spreads. Boats of different speeds bid the
 * time that they take for it, with the turns of those that do not turn on the spot.
 *
 * <p>Cost: L locations and B boats with k locations each take at most O(L B k²) steps; a bid computes only the part of the path that the location
 * changes, and stops once it has lost. After {@link #LIMIT} distances the auction ends: each remaining location goes to the boat whose path it
 * lengthens least, and the division says so. The limit is a count and not a time, so that equal problems have equal answers.
 */
public final class SequentialSingleItemAuction extends AllocationAlgorithm {
    /** Some two seconds' worth. */
    static final long LIMIT = 400_000_000;

    @Override
    public String name() {
        return "Sequential single-item auction";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(Criterion.COMPUTATION_TIME, Merit.BEST, Criterion.EXECUTION_TIME, Merit.GOOD);
    }

    @Override
    List<List<Integer>> shares(AllocationProblem problem, TravelCosts legs) {
        List<NearestNeighbourPath> paths = new ArrayList<>();
        for (int boat = 0; boat < problem.boats().size(); boat++) {
            paths.add(new NearestNeighbourPath(legs, boat));
        }
        int locations = problem.work().size();
        int location = 0;
        while (location < locations && legs.measured() < LIMIT) {
            auction(location, legs, paths);
            location++;
        }
        List<List<Integer>> shares = new ArrayList<>(
                paths.stream().map(NearestNeighbourPath::locations).toList());
        if (location < locations) {
            legs.fallShort("the auction ended at its limit after " + location + " of " + locations
                    + " locations; the others are where they make a path least longer");
            shares.replaceAll(ArrayList::new);
            CheapestInsertion.insert(location, problem, legs, shares);
        }
        return shares;
    }

    private static void auction(int location, TravelCosts legs, List<NearestNeighbourPath> paths) {
        double best = Double.POSITIVE_INFINITY;
        int winner = -1;
        for (int boat = 0; boat < paths.size(); boat++) {
            if (legs.canDo(boat, location)) {
                double bid = legs.timeM(boat, paths.get(boat).lengthWith(location, legs.lengthM(boat, best)));
                if (winner < 0 || bid < best) {
                    best = bid;
                    winner = boat;
                }
            }
        }
        paths.get(winner).add(location);
    }
}
