package org.sami.crw.service.allocation;

import java.util.List;
import java.util.Map;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * A division whose longest path is short, as that decides when the last boat is done. For few locations the best there is; for more an
 * auction that a local search balances until no small change helps. What boats have begun counts.
 */
public final class BalancedDivision extends AllocationAlgorithm {
    private final SequentialSingleItemAuction auction = new SequentialSingleItemAuction();

    @Override
    public String name() {
        return "Balanced division";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(Criterion.EXECUTION_TIME, Merit.BEST);
    }

    @Override
    List<List<Integer>> shares(AllocationProblem problem, DistanceTable legs) {
        List<List<Integer>> first = problem.work().size() <= ExactDivision.MOST_WORK
                ? new ExactDivision(problem, legs, Objective.LONGEST).shares()
                : auction.shares(problem, legs);
        return new LocalSearch(problem, legs, Objective.LONGEST, first).run();
    }
}
