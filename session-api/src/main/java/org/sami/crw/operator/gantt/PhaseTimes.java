package org.sami.crw.operator.gantt;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseProgress;
import org.sami.spn.phase.PhaseProgress.Status;
import org.sami.spn.protocol.Effect;

/**
 * When a mission was in which phase of its plan, and did which action. A phase goes on while an action of it does, and after it until an action of another
 * phase begins. For one thread at a time.
 */
final class PhaseTimes {
    private final PhaseChart chart;
    private final PhaseProgress progress;
    private final Map<String, OpenBars> actions = new HashMap<>();
    private final Map<String, Integer> executions = new HashMap<>();
    private final Map<String, OpenBars> phases = new LinkedHashMap<>();

    PhaseTimes(Plan plan, PhaseChart chart, long mission) {
        this.chart = chart;
        progress = new PhaseProgress(chart, plan, mission);
        chart.phases().forEach(phase -> phases.put(phase, new OpenBars()));
        chart.actions().forEach(action -> actions.put(action.id(), new OpenBars()));
    }

    void accept(Effect effect) {
        progress.accept(effect);
    }

    void settle(long atMillis, boolean beganBefore) {
        Map<String, Boolean> goesOn = new LinkedHashMap<>(); // by phase, of those in which something was done
        for (PhaseAction action : chart.actions()) {
            boolean active = progress.status(action.id()) == Status.ACTIVE;
            int times = progress.executions(action.id());
            boolean begun = times > executions.getOrDefault(action.id(), 0);
            executions.put(action.id(), times);
            OpenBars bars = bars(actions, action.id());
            if (active) {
                bars.show(action.label(), atMillis, beganBefore);
            } else if (begun) {
                bars.note(action.label(), atMillis);
            } else {
                bars.end(atMillis);
            }
            if (active || begun) {
                goesOn.merge(action.phase(), active, Boolean::logicalOr);
            }
        }
        if (!goesOn.isEmpty()) {
            boolean anyActive = goesOn.containsValue(true);
            phases.forEach((phase, bars) -> {
                if (goesOn.getOrDefault(phase, false) || (!anyActive && goesOn.containsKey(phase))) {
                    bars.show(phase, atMillis, beganBefore);
                } else {
                    bars.end(atMillis);
                }
            });
        }
    }

    private static OpenBars bars(Map<String, OpenBars> of, String id) {
        return of.computeIfAbsent(id, one -> new OpenBars());
    }

    void end(long atMillis) {
        actions.values().forEach(bars -> bars.end(atMillis));
        phases.values().forEach(bars -> bars.end(atMillis));
    }

    PhaseChart chart() {
        return chart;
    }

    Map<String, String> taken() {
        return progress.taken();
    }

    List<GanttPhase> phases() {
        List<GanttPhase> all = new ArrayList<>();
        phases.forEach((name, bars) -> {
            List<GanttBar> times = bars.all();
            Status status =
                    times.isEmpty() ? Status.AHEAD : times.get(times.size() - 1).goesOn() ? Status.ACTIVE : Status.DONE;
            all.add(new GanttPhase(name, status, times, actionsOf(name)));
        });
        return all;
    }

    /** Those that were begun, and those ahead on the branches that were taken, where none was yet on the first; in the order of the chart. */
    private List<GanttAction> actionsOf(String phase) {
        Set<String> ahead = chart.view(phase, progress.taken()).boxes().stream()
                .map(box -> box.action().id())
                .collect(Collectors.toSet());
        return chart.actions().stream()
                .filter(action -> action.phase().equals(phase))
                .filter(action -> ahead.contains(action.id()) || progress.executions(action.id()) > 0)
                .map(action -> new GanttAction(
                        action,
                        progress.status(action.id()),
                        progress.executions(action.id()),
                        bars(actions, action.id()).all()))
                .toList();
    }
}
