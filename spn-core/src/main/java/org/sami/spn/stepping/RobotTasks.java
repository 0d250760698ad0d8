package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.sami.spn.engine.AlikeKey;
import org.sami.spn.protocol.Effect;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Which tasks each robot has left and with which it has begun, as a domain keeps them: a robot does one task after another, in the order in
 * which it got them. The engine knows only who has a task.
 */
final class RobotTasks {
    private final Map<String, List<TaskId>> queues = new TreeMap<>();
    private final Set<TaskId> started = new HashSet<>();

    RobotTasks copy() {
        RobotTasks copy = new RobotTasks();
        queues.forEach((robot, tasks) -> copy.queues.put(robot, new ArrayList<>(tasks)));
        copy.started.addAll(started);
        return copy;
    }

    /** Follows the engine's effects: tasks get a robot or lose it, a plan says that tasks are complete, a mission ends. */
    void saw(Effect effect, Vocabulary vocabulary) {
        if (effect instanceof Effect.TasksAllocated allocated) {
            allocated.robots().forEach((task, robot) -> {
                boolean same = robot.map(queues::get)
                        .filter(tasks -> tasks.contains(task))
                        .isPresent();
                if (!same) {
                    remove(task);
                    robot.ifPresent(to ->
                            queues.computeIfAbsent(to, r -> new ArrayList<>()).add(task));
                }
            });
        } else if (effect instanceof Effect.Activated activated && completes(activated, vocabulary)) {
            activated.activation().tasks().forEach(this::remove);
        } else if (effect instanceof Effect.MissionEnded ended) {
            List.copyOf(queues.values())
                    .forEach(tasks -> List.copyOf(tasks).stream()
                            .filter(task -> task.mission() == ended.mission())
                            .forEach(this::remove));
        }
    }

    private static boolean completes(Effect.Activated activated, Vocabulary vocabulary) {
        return vocabulary.event(activated.activation().type()).stream()
                .flatMap(type -> type.answers().stream())
                .flatMap(answer -> vocabulary.event(answer).stream())
                .anyMatch(type -> type.flags().contains(EventFlag.TASK_COMPLETED));
    }

    private void remove(TaskId task) {
        started.remove(task);
        queues.values().forEach(tasks -> tasks.remove(task));
        queues.values().removeIf(List::isEmpty);
    }

    /** Follows an input event that was received: with a task that it says has started its robot has begun; other news of a task ends that. */
    void received(EventType type, List<TaskId> named) {
        if (type.flags().contains(EventFlag.TASK_STARTED)) {
            started.addAll(named);
        } else if (type.flags().contains(EventFlag.TASK_COMPLETED)) {
            named.forEach(this::remove);
        } else if (type.tokens() == TokenNeed.TASK && type.flags().contains(EventFlag.NEWS)) {
            named.forEach(this::putBack);
        }
    }

    private void putBack(TaskId task) {
        started.remove(task);
        queues.values().stream().filter(tasks -> tasks.remove(task)).forEach(tasks -> tasks.add(task));
    }

    /** The tasks with which a robot begins next, by robot: the first that it has left, where it has not begun with that. */
    Map<String, TaskId> startable() {
        Map<String, TaskId> next = new LinkedHashMap<>();
        queues.forEach((robot, tasks) -> {
            if (!started.contains(tasks.get(0))) {
                next.put(robot, tasks.get(0));
            }
        });
        return next;
    }

    /** Adds the queues to a key. */
    void addTo(AlikeKey key) {
        queues.forEach((robot, tasks) -> {
            for (int i = 0; i < tasks.size(); i++) {
                key.left(robot, i, tasks.get(i), started.contains(tasks.get(i)));
            }
        });
    }

    /** What the queues are, to compare two moments by. */
    String words() {
        StringBuilder words = new StringBuilder();
        queues.forEach((robot, tasks) -> {
            words.append(robot).append(':');
            tasks.forEach(task -> words.append(started.contains(task) ? '*' : '-')
                    .append(task.mission())
                    .append('/')
                    .append(task.name())
                    .append(';'));
        });
        return words.toString();
    }
}
