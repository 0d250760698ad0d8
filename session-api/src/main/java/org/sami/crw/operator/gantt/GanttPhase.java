package org.sami.crw.operator.gantt;

import java.util.List;
import java.util.Objects;
import org.sami.spn.phase.PhaseProgress.Status;

/**
 * A phase of a mission's plan, and when the mission was in it.
 *
 * @param status whether the mission is in it now, was, or has not reached it
 * @param actions in the order in which the net lets them follow one another
 */
public record GanttPhase(String name, Status status, List<GanttBar> bars, List<GanttAction> actions) {
    public GanttPhase {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(status, "status");
        bars = List.copyOf(bars);
        actions = List.copyOf(actions);
    }

    /** How many of its actions have been begun at least once. */
    public int begun() {
        return (int) actions.stream()
                .filter(action -> action.status() != Status.AHEAD)
                .count();
    }
}
