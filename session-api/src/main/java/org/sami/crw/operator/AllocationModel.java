package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.sami.crw.operator.mission.AllocationSnapshot;
import org.sami.crw.task.TaskQueue;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.NaturalOrder;
import org.sami.spn.value.TaskId;

/** Who has which tasks. Follows the engine's allocations and the queues that the session remembers. */
public final class AllocationModel extends Model<AllocationSnapshot> {
    private final Map<String, List<TaskId>> queues = new TreeMap<>();
    private final Set<TaskId> known = new LinkedHashSet<>();
    private final Map<TaskId, String> robots = new LinkedHashMap<>();
    private final Set<TaskId> complete = new LinkedHashSet<>();

    AllocationModel() {
        super(AllocationSnapshot.EMPTY);
    }

    /** Forgets all. */
    void clear() {
        queues.clear();
        known.clear();
        robots.clear();
        complete.clear();
        change();
    }

    /** Takes up a state that was restored. */
    void restore(
            List<TaskId> tasks, Map<TaskId, String> allocation, Set<TaskId> completed, Map<String, TaskQueue> queued) {
        known.addAll(tasks);
        robots.putAll(allocation);
        complete.addAll(completed);
        queued.forEach((boat, queue) -> queues.put(boat, queue.tasks()));
        change();
    }

    /**
     * One step of the engine.
     *
     * @param newTasks tasks that came to be with it
     */
    void apply(Input input, List<Effect> effects, List<TaskId> newTasks) {
        if (known.addAll(newTasks)) {
            change();
        }
        TaskQueues.remembered(input).ifPresent(queue -> {
            queues.put(queue.getKey(), queue.getValue().tasks());
            change();
        });
        TaskQueues.completed(input).ifPresent(task -> {
            if (task.getValue()) {
                complete.add(task.getKey());
            } else {
                complete.remove(task.getKey());
            }
            change();
        });
        for (Effect effect : effects) {
            if (effect instanceof Effect.TasksAllocated allocated) {
                allocated.robots().forEach(this::allocated);
                change();
            } else if (effect instanceof Effect.MissionEnded ended && ended.outcome() != Outcome.HALTED) {
                ended(ended.mission());
            }
        }
    }

    private void allocated(TaskId task, Optional<String> robot) {
        robot.ifPresentOrElse(boat -> robots.put(task, boat), () -> robots.remove(task));
    }

    private void ended(long mission) {
        boolean changed = known.removeIf(task -> task.mission() == mission);
        robots.keySet().removeIf(task -> task.mission() == mission);
        complete.removeIf(task -> task.mission() == mission);
        if (changed) {
            change();
        }
    }

    private static void add(Map<String, List<TaskId>> filled, String boat, TaskId task) {
        filled.computeIfAbsent(boat, id -> new ArrayList<>()).add(task);
    }

    @Override
    AllocationSnapshot take() {
        Map<String, List<TaskId>> filled = new TreeMap<>(NaturalOrder.INSTANCE);
        queues.forEach((boat, tasks) -> tasks.stream()
                .filter(task -> boat.equals(robots.getOrDefault(task, boat)))
                .forEach(task -> add(filled, boat, task)));
        robots.forEach((task, boat) -> { // a moment ago, and not in its queue yet
            if (known.contains(task)
                    && !complete.contains(task)
                    && !filled.getOrDefault(boat, List.of()).contains(task)) {
                add(filled, boat, task);
            }
        });
        List<TaskId> unallocated = known.stream()
                .filter(task -> !robots.containsKey(task) && !complete.contains(task))
                .toList();
        return new AllocationSnapshot(filled, unallocated);
    }
}
