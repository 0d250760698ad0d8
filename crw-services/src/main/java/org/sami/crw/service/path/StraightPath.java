package org.sami.crw.service.path;

import java.util.List;
import java.util.Map;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.choice.Merit;

/** The straight way, where nothing forbidden is on it or too near for boats to be held off. One test, so the fastest to compute. */
public final class StraightPath implements PathAlgorithm {
    @Override
    public String name() {
        return "Straight path";
    }

    @Override
    public Map<Criterion, Merit> serves() {
        return Map.of(Criterion.COMPUTATION_TIME, Merit.BEST);
    }

    @Override
    public PathAnswer find(PathProblem problem) {
        double clearanceM = problem.water().clearanceM(List.of(problem.from(), problem.to()));
        if (clearanceM <= problem.water().error().steeringM()) {
            return new PathAnswer.NoWay("the straight way leads through what is forbidden, or past it too near", 1);
        }
        double lengthM = Geodesy.distanceM(problem.from(), problem.to());
        return new PathAnswer.Way(
                List.of(problem.to()),
                lengthM,
                clearanceM,
                problem.water().error().steeringM(),
                lengthM,
                name(),
                1);
    }
}
