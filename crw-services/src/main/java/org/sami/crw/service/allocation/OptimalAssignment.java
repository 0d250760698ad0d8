package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * At most one work for each boat, so that the sum of the ways is the least possible: the assignment problem, solved to the optimum.
 * Only where there are not more works than boats, and where the boats' capabilities allow it. The straight paths of two boats do not cross, as exchanging
 * their works would be shorter, unless capabilities or charges forbid the exchange.
 */
public final class OptimalAssignment extends AllocationAlgorithm {
    /** Costs more than any way on earth. */
    private static final double FORBIDDEN = 1e9;

    @Override
    public String name() {
        return "Optimal assignment";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(
                Criterion.EXECUTION_SAFETY, Merit.BEST,
                Criterion.EXECUTION_TIME, Merit.FAIR,
                Criterion.EXECUTION_EFFICIENCY, Merit.FAIR);
    }

    @Override
    public Optional<String> whyNot(AllocationProblem problem) {
        AllocationProblem possible = problem.possible();
        int works = possible.work().size();
        int boats = possible.boats().size();
        if (works > boats) {
            return Optional.of(works + " locations for " + (boats == 1 ? "one boat" : boats + " boats")
                    + " are more than one each");
        }
        return assign(possible, new TravelCosts(possible)).isPresent()
                ? Optional.empty()
                : Optional.of("capabilities do not allow one location for each boat");
    }

    @Override
    List<List<Integer>> shares(AllocationProblem problem, TravelCosts legs) {
        int[] boatOf = assign(problem, legs).orElseThrow();
        List<List<Integer>> shares = new ArrayList<>();
        problem.boats().forEach(boat -> shares.add(new ArrayList<>()));
        for (int work = 0; work < boatOf.length; work++) {
            shares.get(boatOf[work]).add(work);
        }
        return shares;
    }

    private static Optional<int[]> assign(AllocationProblem problem, TravelCosts legs) {
        double[][] costs = new double[problem.work().size()][problem.boats().size()];
        for (int work = 0; work < costs.length; work++) {
            for (int boat = 0; boat < costs[work].length; boat++) {
                costs[work][boat] = legs.canDo(boat, work) ? legs.first(boat, work) : FORBIDDEN;
            }
        }
        int[] boatOf = LeastSumAssignment.of(costs);
        for (int work = 0; work < boatOf.length; work++) {
            if (costs[work][boatOf[work]] >= FORBIDDEN) {
                return Optional.empty();
            }
        }
        return Optional.of(boatOf);
    }
}
