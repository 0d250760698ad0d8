package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * A division whose paths have a small sum, for any number of locations: each location goes where it costs least, then {@link RuinAndRecreate} and a local
 * search make it better. Not the optimum: within a percent of it on problems small enough to know it. Boats that are far off may
 * get nothing. Straight paths of two boats do not cross where capabilities and charges do not force them to.
 */
public final class LeastTotalDivision extends AllocationAlgorithm {
    @Override
    public String name() {
        return "Least total division";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(Criterion.EXECUTION_EFFICIENCY, Merit.GOOD, Criterion.EXECUTION_SAFETY, Merit.GOOD);
    }

    @Override
    List<List<Integer>> shares(AllocationProblem problem, TravelCosts legs) {
        List<List<Integer>> shares = searched(legs, cheapestInsertion(problem, legs));
        if (problem.work().size() <= RuinAndRecreate.MOST_WORK) {
            shares = searched(legs, new RuinAndRecreate(problem, legs, Objective.TOTAL, shares).run());
        }
        return shares;
    }

    private static List<List<Integer>> searched(TravelCosts legs, List<List<Integer>> shares) {
        return new LocalSearch(legs, Objective.TOTAL, shares).run();
    }

    private static List<List<Integer>> cheapestInsertion(AllocationProblem problem, TravelCosts legs) {
        List<List<Integer>> shares = new ArrayList<>();
        problem.boats().forEach(boat -> shares.add(new ArrayList<>()));
        CheapestInsertion.insert(0, problem, legs, shares);
        return shares;
    }
}
