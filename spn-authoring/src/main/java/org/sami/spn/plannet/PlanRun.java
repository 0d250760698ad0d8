package org.sami.spn.plannet;

import java.util.List;

/**
 * A run of a plan's net in the words of the plan.
 *
 * @param markings one more than there are firings: before the first and after each
 */
public record PlanRun(List<PlanNetFiring> firings, List<PlanMarking> markings) {
    public PlanRun {
        firings = List.copyOf(firings);
        markings = List.copyOf(markings);
    }
}
