package org.sami.crw.operator.gantt;

import java.util.List;
import java.util.Objects;

/**
 * A robot in a mission: at which of the plan's places it was when.
 *
 * @param name of the robot
 * @param bars in order of time, one after another
 */
public record GanttRow(String name, List<GanttBar> bars) {
    public GanttRow {
        Objects.requireNonNull(name, "name");
        bars = List.copyOf(bars);
    }
}
