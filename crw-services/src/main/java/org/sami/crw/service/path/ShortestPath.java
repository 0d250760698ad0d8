package org.sami.crw.service.path;

import java.util.Map;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;
import org.sami.crw.service.water.Water;

/** The shortest way around what is forbidden, passing its corners as near as boats can be held to their ways ({@link Water#error}). */
public final class ShortestPath implements PathAlgorithm {
    @Override
    public String name() {
        return "Shortest path";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(
                Criterion.EXECUTION_TIME, Merit.BEST,
                Criterion.EXECUTION_EFFICIENCY, Merit.BEST,
                Criterion.COMPUTATION_TIME, Merit.GOOD);
    }

    @Override
    public PathAnswer find(PathProblem problem) {
        return new WayAround(problem, name()).find(problem.water().margin().pathM());
    }
}
