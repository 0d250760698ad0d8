package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.service.choice.Choice;
import org.sami.crw.service.choice.Criterion;

/**
 * Solves allocation problems with the algorithm that serves a criterion best, or with several of them where a choice of options is
 * wanted.
 */
public final class AllocationService {
    /** The auction first: it is the standard (thesis 7.0.3). */
    public static final AllocationService STANDARD = new AllocationService(List.of(
            new SequentialSingleItemAuction(),
            new BalancedDivision(),
            new OptimalDivision(),
            new LeastTotalDivision(),
            new OptimalAssignment()));

    private final List<AllocationAlgorithm> algorithms;

    /** A service with at least one algorithm, the standard one first. */
    public AllocationService(List<AllocationAlgorithm> algorithms) {
        this.algorithms = List.copyOf(algorithms);
        if (algorithms.isEmpty()) {
            throw new IllegalArgumentException("At least one allocation algorithm is needed");
        }
    }

    /** The algorithms, the standard one first. */
    public List<AllocationAlgorithm> algorithms() {
        return algorithms;
    }

    /**
     * Options for a problem.
     *
     * @param divisions different from one another, the best by the criterion first as measured; the one of the chosen algorithm is
     *     among them. May be fewer than were asked for: then there are no more
     * @param reason why that algorithm was chosen, for people
     */
    public record Options(List<Division> divisions, String reason) {
        public Options {
            divisions = List.copyOf(divisions);
        }

        /** The best one. */
        public Division best() {
            return divisions.get(0);
        }
    }

    /** Solves a problem in up to so many ways, by what the algorithms declare; without a criterion the standard one first. */
    public Options solve(AllocationProblem problem, Optional<Criterion> criterion, int wanted) {
        if (wanted < 1) {
            throw new IllegalArgumentException("At least one option must be wanted, not " + wanted);
        }
        Choice<AllocationAlgorithm> choice = Choice.of(algorithms, problem, criterion);
        List<Division> found = new ArrayList<>();
        Set<Map<String, List<WorkItem>>> seen = new HashSet<>();
        for (AllocationAlgorithm algorithm : choice.ranked()) {
            if (found.size() < wanted) {
                Division division = algorithm.divide(problem);
                if (seen.add(division.paths())) {
                    found.add(division);
                }
            }
        }
        criterion.ifPresent(by -> found.sort(Division.by(by)));
        return new Options(found, choice.reason());
    }
}
