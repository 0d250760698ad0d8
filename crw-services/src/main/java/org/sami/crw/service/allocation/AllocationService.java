package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.Comparator;
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
     * @param divisions different from one another, measured by the criterion, best first; the division of the chosen algorithm is among them.
     *     There may be fewer than asked for
     * @param reason why that algorithm was chosen, for people
     * @param reasons the reason for each division, in their order; the chosen algorithm's division has the same reason
     */
    public record Options(List<Division> divisions, String reason, List<String> reasons) {
        public Options {
            divisions = List.copyOf(divisions);
            reasons = List.copyOf(reasons);
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
        List<Offered> found = new ArrayList<>();
        Set<Map<String, List<WorkItem>>> seen = new HashSet<>();
        for (AllocationAlgorithm algorithm : choice.ranked()) {
            if (found.size() < wanted) {
                Division division = algorithm.divide(problem);
                if (seen.add(division.paths())) {
                    found.add(new Offered(division, reason(algorithm, choice, criterion)));
                }
            }
        }
        criterion.ifPresent(by -> found.sort(Comparator.comparing(Offered::division, Division.by(by))));
        return new Options(
                found.stream().map(Offered::division).toList(),
                choice.reason(),
                found.stream().map(Offered::reason).toList());
    }

    private record Offered(Division division, String reason) {}

    private static String reason(
            AllocationAlgorithm algorithm, Choice<AllocationAlgorithm> choice, Optional<Criterion> criterion) {
        if (algorithm == choice.first()) {
            return choice.reason();
        }
        String merit = criterion
                .map(wanted -> Optional.ofNullable(algorithm.serves().get(wanted))
                        .map(how -> ", " + how.words() + " for " + wanted.words())
                        .orElse(", which does not say that it serves " + wanted.words()))
                .orElse("");
        return algorithm.name() + merit + "; offered beside " + choice.first().name()
                + ", as several options were wanted";
    }
}
