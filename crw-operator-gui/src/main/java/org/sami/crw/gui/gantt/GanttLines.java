package org.sami.crw.gui.gantt;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.gui.gantt.GanttLine.Kind;
import org.sami.crw.operator.gantt.GanttAction;
import org.sami.crw.operator.gantt.GanttBar;
import org.sami.crw.operator.gantt.GanttMission;
import org.sami.crw.operator.gantt.GanttPhase;
import org.sami.crw.operator.gantt.GanttRow;
import org.sami.spn.phase.PhaseProgress.Status;

/**
 * The lines of the chart: missions that run before those that have ended, the latest first; below each its phases and its robots, and below a phase its actions. At first
 * the missions that run are open; what somebody has opened or closed stays so. On the event thread.
 */
final class GanttLines {
    private final Map<String, Boolean> chosen = new HashMap<>();
    private List<GanttMission> missions = List.of();

    /** Takes what is so now. */
    void show(List<GanttMission> now) {
        missions = List.copyOf(now);
    }

    /** Opens a line that is closed, and closes one that is open; one without lines below it stays as it is. */
    void toggle(GanttLine line) {
        line.open().ifPresent(open -> chosen.put(line.id(), !open));
    }

    /** The lines that are not folded away, from the top. */
    List<GanttLine> lines() {
        List<GanttLine> lines = new ArrayList<>();
        List<GanttMission> order = new ArrayList<>(missions);
        Collections.reverse(order);
        order.stream().filter(GanttMission::runs).forEach(mission -> add(mission, lines));
        order.stream().filter(mission -> !mission.runs()).forEach(mission -> add(mission, lines));
        return lines;
    }

    /** When the earliest mission of those that run started; of those that have ended where none runs; empty where there is none. */
    OptionalLong start() {
        boolean some = missions.stream().anyMatch(GanttMission::runs);
        return missions.stream()
                .filter(mission -> mission.runs() || !some)
                .mapToLong(GanttMission::startedAtMillis)
                .min();
    }

    /** When the last mission ended, where none runs. */
    OptionalLong end() {
        return missions.stream().anyMatch(GanttMission::runs)
                ? OptionalLong.empty()
                : missions.stream()
                        .flatMapToLong(mission -> mission.endedAtMillis().stream())
                        .max();
    }

    private void add(GanttMission mission, List<GanttLine> lines) {
        String id = "mission-" + mission.id();
        boolean open = chosen.getOrDefault(id, mission.runs());
        boolean hasLines = !mission.phases().isEmpty() || !mission.robots().isEmpty();
        lines.add(new GanttLine(
                id,
                Kind.MISSION,
                0,
                mission.title(),
                "",
                mission.runs() ? Status.ACTIVE : Status.DONE,
                Optional.empty(),
                hasLines ? Optional.of(open) : Optional.empty(),
                List.of(new GanttBar(mission.title(), mission.startedAtMillis(), false, mission.endedAtMillis()))));
        if (open) {
            mission.phases().forEach(phase -> add(id, phase, lines));
            mission.robots().forEach(robot -> lines.add(line(id, robot)));
        }
    }

    private void add(String mission, GanttPhase phase, List<GanttLine> lines) {
        String id = mission + "/" + phase.name();
        boolean open = chosen.getOrDefault(id, false); // robots are in sight at first
        lines.add(new GanttLine(
                id,
                Kind.PHASE,
                1,
                phase.name(),
                phase.begun() + " of " + phase.actions().size(),
                phase.status(),
                Optional.empty(),
                Optional.of(open),
                phase.bars()));
        if (open) {
            phase.actions().forEach(action -> lines.add(line(id, action)));
        }
    }

    private static GanttLine line(String phase, GanttAction action) {
        return new GanttLine(
                phase + "/" + action.action().id(),
                Kind.ACTION,
                2,
                action.action().actor() + ": " + action.action().label(),
                action.executions() > 1 ? action.executions() + " times" : "",
                action.status(),
                Optional.empty(),
                Optional.empty(),
                action.bars());
    }

    private static GanttLine line(String mission, GanttRow robot) {
        boolean goesOn = robot.bars().stream().anyMatch(GanttBar::goesOn);
        return new GanttLine(
                mission + "/robot/" + robot.name(),
                Kind.ROBOT,
                1,
                robot.name(),
                "",
                goesOn ? Status.ACTIVE : Status.DONE,
                Optional.of(robot.name()),
                Optional.empty(),
                robot.bars());
    }
}
