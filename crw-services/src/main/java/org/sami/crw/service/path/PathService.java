package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.service.choice.Choice;
import org.sami.crw.service.choice.Criterion;

/** Finds ways with the algorithm that serves a criterion best; where that finds none, with the next one. */
public final class PathService {
    /** The shortest first: it is the standard. */
    public static final PathService STANDARD =
            new PathService(List.of(new ShortestPath(), new SafestPath(), new StraightPath()));

    private final List<PathAlgorithm> algorithms;

    /** A service with at least one algorithm, the standard one first. */
    public PathService(List<PathAlgorithm> algorithms) {
        this.algorithms = List.copyOf(algorithms);
    }

    /**
     * Ways for a problem.
     *
     * @param ways different from one another, in the order of what the algorithms declare; none where there is no way
     * @param reason why the first was chosen, or why there is no way, for people
     */
    public record Options(List<PathAnswer.Way> ways, String reason) {
        public Options {
            ways = List.copyOf(ways);
        }
    }

    /** Finds up to so many ways. */
    public Options find(PathProblem problem, Optional<Criterion> criterion, int wanted) {
        Choice<PathAlgorithm> choice = Choice.of(algorithms, problem, criterion);
        List<PathAnswer.Way> ways = new ArrayList<>();
        List<String> reasons = new ArrayList<>(List.of(choice.reason()));
        String noWay = "";
        for (PathAlgorithm algorithm : choice.ranked()) {
            if (ways.size() >= wanted) {
                break;
            }
            PathAnswer answer = algorithm.find(problem);
            if (answer instanceof PathAnswer.NoWay none) {
                noWay = algorithm == algorithms.get(0) ? none.reason() : noWay;
                reasons.add(algorithm.name() + " found none: " + none.reason());
            } else if (answer instanceof PathAnswer.Way way
                    && ways.stream().noneMatch(other -> other.points().equals(way.points()))) {
                ways.add(way);
            }
        }
        return new Options(ways, ways.isEmpty() ? "There is no way: " + noWay : String.join("; ", reasons));
    }
}
