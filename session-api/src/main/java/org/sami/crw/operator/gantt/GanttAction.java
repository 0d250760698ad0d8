package org.sami.crw.operator.gantt;

import java.util.List;
import java.util.Objects;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseProgress.Status;

/**
 * An action of a phase, and when it was done.
 *
 * @param executions how often it was begun
 * @param bars in order of time; what takes no time, such as a choice, has a bar without length
 */
public record GanttAction(PhaseAction action, Status status, int executions, List<GanttBar> bars) {
    public GanttAction {
        Objects.requireNonNull(action, "action");
        Objects.requireNonNull(status, "status");
        bars = List.copyOf(bars);
    }
}
