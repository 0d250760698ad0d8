package org.sami.crw.service.allocation;

import java.util.List;
import org.sami.crw.service.choice.DeclaredAlgorithm;

/**
 * Divides work among boats and puts each boat's work in order. Deterministic; no state. Implementations see only work that at
 * least one boat can do.
 */
public abstract class AllocationAlgorithm implements DeclaredAlgorithm<AllocationProblem> {

    /**
     * A division in which each work that a boat can do is on exactly one path, of a boat that can do it; no path is longer than its boat's charge
     * lasts where {@link RangeRepair} finds a way.
     */
    public final Division divide(AllocationProblem problem) {
        AllocationProblem possible = problem.possible();
        TravelCosts legs = new TravelCosts(possible);
        List<List<Integer>> shares = RangeRepair.of(possible, legs, shares(possible, legs));
        return Division.of(problem, possible, shares, legs, name());
    }

    /** The indices of each boat's work in its order, by the boat's index. */
    abstract List<List<Integer>> shares(AllocationProblem problem, TravelCosts legs);
}
