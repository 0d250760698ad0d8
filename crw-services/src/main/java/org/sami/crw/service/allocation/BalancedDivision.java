package org.sami.crw.service.allocation;

import java.util.List;
import java.util.Map;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * A division whose longest path is short, as that decides when the last boat is done. For few locations the best there is; for more an
 * auction's that {@link RuinAndRecreate} balances, and a local search alone beyond {@link RuinAndRecreate#MOST_WORK} locations. Never worse than the auction.
 * What boats have begun counts. For boats with turning circles
 * {@link TurnSearch} comes last.
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
    List<List<Integer>> shares(AllocationProblem problem, TravelCosts legs) {
        if (!legs.hasTurns()) {
            return byLength(problem, legs);
        }
        List<List<Integer>> auctioned =
                auction.shares(problem, legs); // first, as what the search measures counts against its limit
        AllocationProblem onTheSpot = problem.turningOnTheSpot();
        TravelCosts straight = new TravelCosts(onTheSpot);
        List<List<Integer>> byLength = byLength(onTheSpot, straight);
        legs.count(straight.measured());
        straight.shortfall().filter(words -> legs.shortfall().isEmpty()).ifPresent(legs::fallShort);
        return TurnSearch.best(legs, Objective.LONGEST, List.of(byLength, auctioned));
    }

    /** As if all boats turned on the spot. */
    private List<List<Integer>> byLength(AllocationProblem problem, TravelCosts legs) {
        int works = problem.work().size();
        if (works <= ExactDivision.MOST_WORK) {
            return polished(legs, new ExactDivision(problem, legs, Objective.LONGEST).shares());
        }
        List<List<Integer>> auctioned = auction.shares(problem, legs);
        return works <= RuinAndRecreate.MOST_WORK
                ? polished(legs, new RuinAndRecreate(problem, legs, Objective.LONGEST, auctioned).run())
                : polished(legs, auctioned);
    }

    /** The same with shorter paths of the other boats. */
    private static List<List<Integer>> polished(TravelCosts legs, List<List<Integer>> shares) {
        return new LocalSearch(legs, Objective.LONGEST, shares).run();
    }
}
