package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.spn.protocol.Effect;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The tasks that each robot has, in order, and the news of them that follow from what a plan allocates (docs/language.md): released,
 * unassigned, reassigned, delayed, started.
 */
final class TaskNewsWatch {
    /** One thing that happened to a task. */
    record News(String type, TaskId task, List<String> robots) {}

    private final Vocabulary vocabulary;
    private final Map<String, List<TaskId>> queues = new TreeMap<>();
    private final List<News> news = new ArrayList<>();

    TaskNewsWatch(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    void saw(Effect effect) {
        Map<String, List<TaskId>> before = copy();
        if (effect instanceof Effect.TasksAllocated allocated) {
            allocated(allocated);
        } else if (effect instanceof Effect.Activated activated && completes(activated)) {
            queues.values()
                    .forEach(queue -> queue.removeAll(activated.activation().tasks()));
        } else if (effect instanceof Effect.MissionEnded ended) {
            queues.values().forEach(queue -> queue.removeIf(task -> task.mission() == ended.mission()));
        } else {
            return;
        }
        tellOrder(before);
    }

    /** The news since it was last asked, in the order in which they came. */
    List<News> take() {
        List<News> taken = List.copyOf(news);
        news.clear();
        return taken;
    }

    private Map<String, List<TaskId>> copy() {
        Map<String, List<TaskId>> copy = new HashMap<>();
        queues.forEach((robot, queue) -> copy.put(robot, List.copyOf(queue)));
        return copy;
    }

    private boolean completes(Effect.Activated activated) {
        return vocabulary.event(activated.activation().type()).stream()
                .flatMap(type -> type.answers().stream())
                .flatMap(answer -> vocabulary.event(answer).stream())
                .anyMatch(type -> type.flags().contains(EventFlag.TASK_COMPLETED));
    }

    private void allocated(Effect.TasksAllocated allocated) {
        Map<String, List<TaskId>> given = new LinkedHashMap<>();
        allocated.robots().forEach((task, robot) -> {
            Optional<String> had = Optional.ofNullable(allocated.before().get(task));
            if (had.isPresent() && !had.equals(robot)) {
                boolean worked = queues.getOrDefault(had.get(), List.of()).contains(task);
                queues.computeIfAbsent(had.get(), name -> new ArrayList<>()).remove(task);
                if (worked) {
                    news.add(new News("TaskReleased", task, List.of(had.get())));
                    news.add(robot.map(to -> new News("TaskReassigned", task, List.of(to)))
                            .orElse(new News("TaskUnassigned", task, List.of())));
                }
            }
            robot.ifPresent(
                    to -> given.computeIfAbsent(to, name -> new ArrayList<>()).add(task));
        });
        given.forEach((robot, tasks) -> queues.put(robot, reordered(queues.getOrDefault(robot, List.of()), tasks)));
    }

    /** Those that were there already keep their places, in the new order; the others follow. */
    private static List<TaskId> reordered(List<TaskId> before, List<TaskId> given) {
        List<TaskId> after = new ArrayList<>();
        int next = 0;
        for (TaskId task : before) {
            after.add(given.contains(task) ? given.get(next++) : task);
        }
        after.addAll(given.subList(next, given.size()));
        return after;
    }

    private void tellOrder(Map<String, List<TaskId>> before) {
        queues.forEach((robot, queue) -> {
            List<TaskId> old = before.getOrDefault(robot, List.of());
            for (TaskId task : queue) {
                if (old.contains(task) && queue.indexOf(task) > old.indexOf(task)) {
                    news.add(new News("TaskDelayed", task, List.of(robot)));
                }
            }
            if (!queue.isEmpty() && (old.isEmpty() || !old.get(0).equals(queue.get(0)))) {
                news.add(new News("TaskStarted", queue.get(0), List.of(robot)));
            }
        });
    }
}
