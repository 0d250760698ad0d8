package org.sami.crw.operator.gantt;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseProgress.Status;

/**
 * A mission over time.
 *
 * @param title what people call it
 * @param startedAtMillis on the session's clock
 * @param endedAtMillis empty while it runs
 * @param phases of its plan, in the order in which they are reached; empty where the plan names none (markup Phase Item)
 * @param robots that had a token or a task in it or in a sub-mission of it, sorted by name
 * @param chart of its plan, without any action where the plan names no phases
 * @param taken the branches that were taken last, by the action that has them
 */
public record GanttMission(
        long id,
        String title,
        long startedAtMillis,
        OptionalLong endedAtMillis,
        List<GanttPhase> phases,
        List<GanttRow> robots,
        PhaseChart chart,
        Map<String, String> taken) {
    public GanttMission {
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(endedAtMillis, "endedAtMillis");
        phases = List.copyOf(phases);
        robots = List.copyOf(robots);
        Objects.requireNonNull(chart, "chart");
        taken = Map.copyOf(taken);
    }

    /** Whether it has not ended. */
    public boolean runs() {
        return endedAtMillis.isEmpty();
    }

    /** How an action stands, by its event's id; ahead where the plan has no such action. */
    public Status status(String action) {
        return action(action).map(GanttAction::status).orElse(Status.AHEAD);
    }

    private Optional<GanttAction> action(String id) {
        return phases.stream()
                .flatMap(phase -> phase.actions().stream())
                .filter(one -> one.action().id().equals(id))
                .findFirst();
    }
}
