package org.sami.crw.gui.gantt;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.operator.gantt.GanttBar;
import org.sami.spn.phase.PhaseProgress.Status;

/**
 * A line of the chart.
 *
 * @param id stable as long as the mission is known
 * @param depth how far it is indented, from 0
 * @param label what stands before its bars
 * @param note how far it is, such as "2 of 5"; empty where there is nothing to say
 * @param robot whose it is; empty where it is no robot's
 * @param open whether the lines below it are shown; empty where there are none
 */
record GanttLine(
        String id,
        Kind kind,
        int depth,
        String label,
        String note,
        Status status,
        Optional<String> robot,
        Optional<Boolean> open,
        List<GanttBar> bars) {
    /** What a line is about. */
    enum Kind {
        /** A mission, from its start to its end. */
        MISSION,
        /** A phase of its plan. */
        PHASE,
        /** An action of a phase. */
        ACTION,
        /** A robot of the mission. */
        ROBOT
    }

    GanttLine {
        Objects.requireNonNull(id, "id");
        bars = List.copyOf(bars);
    }
}
