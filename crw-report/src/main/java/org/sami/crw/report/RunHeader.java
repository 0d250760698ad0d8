package org.sami.crw.report;

import java.util.Objects;
import org.sami.crw.fleet.RobotKind;

/**
 * What was run.
 *
 * @param plan id of the plan
 * @param planName the plan's name for people
 * @param planHash SHA-256, in hexadecimal digits, of the plan as it was run
 * @param mission name of the mission
 * @param speed "max", or how many simulated seconds pass in one second
 * @param areaM side of the square in which locations lie, in metres
 * @param robots what the run commanded: what texts for people call them
 */
public record RunHeader(
        String plan,
        String planName,
        String planHash,
        String mission,
        long seed,
        String speed,
        double areaM,
        RunPlace place,
        RobotKind robots) {
    /** Of a run of boats. */
    public RunHeader(
            String plan,
            String planName,
            String planHash,
            String mission,
            long seed,
            String speed,
            double areaM,
            RunPlace place) {
        this(plan, planName, planHash, mission, seed, speed, areaM, place, RobotKind.BOAT);
    }

    public RunHeader {
        Objects.requireNonNull(robots, "robots");
        Objects.requireNonNull(planHash, "planHash");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(planName, "planName");
        Objects.requireNonNull(mission, "mission");
        Objects.requireNonNull(speed, "speed");
    }
}
