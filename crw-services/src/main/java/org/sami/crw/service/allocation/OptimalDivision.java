package org.sami.crw.service.allocation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * The division with the least sum of all paths, with any number of locations on each. It is solved exactly, and so only for few locations (the
 * problem is NP-hard: with one boat it is the open travelling salesman problem).
 */
public final class OptimalDivision extends AllocationAlgorithm {
    @Override
    public String name() {
        return "Optimal division";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(Criterion.EXECUTION_EFFICIENCY, Merit.BEST, Criterion.EXECUTION_SAFETY, Merit.FAIR);
    }

    @Override
    public Optional<String> whyNot(AllocationProblem problem) {
        int works = problem.possible().work().size();
        return works > ExactDivision.MOST_WORK
                ? Optional.of(
                        works + " locations are more than the " + ExactDivision.MOST_WORK + " for which it is solvable")
                : Optional.empty();
    }

    @Override
    List<List<Integer>> shares(AllocationProblem problem, TravelCosts legs) {
        return new ExactDivision(problem, legs, Objective.TOTAL).shares();
    }
}
