package org.sami.crw.service.path;

import java.util.Map;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/**
 * The shortest of the ways that keep a clearance from what is forbidden wherever there is room. In gaps that are too narrow it keeps as much
 * of it as they allow; around them it goes where that is not too long a detour. A start or a goal nearer than the clearance is
 * left and reached straight.
 */
public final class SafestPath implements PathAlgorithm {
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
        double leastM = problem.water().margin().pathM();
        return new WayAround(problem, name()).find(Math.max(leastM, problem.clearanceM()));
    }
}
