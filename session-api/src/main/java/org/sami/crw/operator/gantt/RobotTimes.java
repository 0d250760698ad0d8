package org.sami.crw.operator.gantt;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.sami.spn.model.Place;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.NaturalOrder;
import org.sami.spn.value.TaskId;

/**
 * At which places of a mission and its sub-missions each robot was: by its own token, and by the tasks that are allocated to it. Of several places the
 * one counts that it came to last, among those that ask something of it. For one thread at a time.
 */
final class RobotTimes {
    private record Stand(Token token, long mission, String place, long visit, String words, boolean acts) {}

    private final List<Stand> stands = new ArrayList<>(); // in order of entry
    private final Map<TaskId, String> tasks = new HashMap<>();
    private final Map<String, OpenBars> robots = new TreeMap<>(NaturalOrder.INSTANCE);
    private boolean moved;

    /** @param place as the plan has it; empty where that is not known */
    void entered(Effect.Entered e, Optional<Place> place) {
        String words = place.map(Place::name).filter(name -> !name.isBlank()).orElse(e.place());
        boolean acts = place.map(
                        one -> !one.outputs().isEmpty() || !one.subMissions().isEmpty())
                .orElse(false);
        for (Token token : e.tokens()) {
            if (!(token instanceof Token.Generic)) {
                stands.add(new Stand(token, e.mission(), e.place(), e.visit(), words, acts));
                moved = true;
            }
        }
    }

    void left(Effect.Left e) {
        for (Token token : e.tokens()) {
            for (int i = 0; i < stands.size(); i++) {
                Stand stand = stands.get(i);
                if (stand.token().equals(token)
                        && stand.mission() == e.mission()
                        && stand.visit() == e.visit()
                        && stand.place().equals(e.place())) {
                    stands.remove(i);
                    moved = true;
                    break;
                }
            }
        }
    }

    void allocated(Map<TaskId, Optional<String>> robotsOfTasks) {
        robotsOfTasks.forEach((task, robot) -> {
            tasks.remove(task);
            robot.ifPresent(one -> tasks.put(task, one));
        });
        moved = true;
    }

    /** A mission or sub-mission is over: nobody is in it any longer. */
    void ended(long mission) {
        moved |= stands.removeIf(stand -> stand.mission() == mission);
    }

    /** A step is over: where robots are now counts from its time on. */
    void settle(long atMillis, boolean beganBefore) {
        if (!moved) {
            return;
        }
        moved = false;
        Map<String, Stand> now = new HashMap<>();
        for (Stand stand : stands) {
            robotOf(stand.token()).ifPresent(robot -> now.merge(robot, stand, RobotTimes::later));
        }
        now.forEach((robot, stand) ->
                robots.computeIfAbsent(robot, name -> new OpenBars()).show(stand.words(), atMillis, beganBefore));
        Set<String> gone = new HashSet<>(robots.keySet());
        gone.removeAll(now.keySet());
        gone.forEach(robot -> robots.getOrDefault(robot, new OpenBars()).end(atMillis));
    }

    private static Stand later(Stand before, Stand next) {
        return before.acts() && !next.acts() ? before : next;
    }

    private Optional<String> robotOf(Token token) {
        return token instanceof Token.Proxy proxy
                ? Optional.of(proxy.proxy())
                : token instanceof Token.Task task ? Optional.ofNullable(tasks.get(task.task())) : Optional.empty();
    }

    void end(long atMillis) {
        stands.clear();
        robots.values().forEach(bars -> bars.end(atMillis));
    }

    List<GanttRow> rows() {
        List<GanttRow> rows = new ArrayList<>();
        robots.forEach((robot, bars) -> rows.add(new GanttRow(robot, bars.all())));
        return rows;
    }
}
