package org.sami.crw.service.path;

import java.util.Map;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * The shortest of the ways that keep a clearance from what is forbidden. Where none keeps all of it, half of it is tried, and so on
 * down to half a metre; then the shortest way at all. A start or a goal nearer than the clearance is left and reached
 * straight.
 */
public final class SafestPath implements PathAlgorithm {
    private static final double LEAST_CLEARANCE_M = 0.5;

    @Override
    public String name() {
        return "Safest path";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(Criterion.EXECUTION_SAFETY, Merit.BEST);
    }

    @Override
    public PathAnswer find(PathProblem problem) {
        WayAround around = new WayAround(problem, name());
        for (double clearanceM = problem.clearanceM(); clearanceM >= LEAST_CLEARANCE_M; clearanceM /= 2) {
            PathAnswer answer = around.find(clearanceM);
            if (answer instanceof PathAnswer.Way) {
                return answer;
            }
        }
        return around.find(0);
    }
}
