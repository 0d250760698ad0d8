package org.sami.crw.sim.report;

import java.util.Objects;

/**
 * What was run.
 *
 * @param plan id of the plan
 * @param planName the plan's name for people
 * @param mission name of the mission
 * @param speed "max", or how many simulated seconds pass in one second
 * @param areaM side of the square in which locations lie, in metres
 */
public record RunHeader(String plan, String planName, String mission, long seed, String speed, double areaM) {
    public RunHeader {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(planName, "planName");
        Objects.requireNonNull(mission, "mission");
        Objects.requireNonNull(speed, "speed");
    }
}
