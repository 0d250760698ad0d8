package org.sami.crw.operator.mission;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.TaskId;

/**
 * A preview of moving a task to another boat, or to none: the changes in the present queues. The session may still refuse the move, where the boat
 * takes no part in the mission.
 *
 * @param from the boat that has the task; empty for none
 * @param to the boat that gets it; empty for none
 * @param place its place among the new boat's tasks, from 1; 0 for none
 * @param interrupts whether the boat that has it is working on it
 * @param next that boat's next task; empty for none
 */
public record TaskMovePreview(
        TaskId task, Optional<String> from, Optional<String> to, int place, boolean interrupts, Optional<TaskId> next) {
    public TaskMovePreview {
        Objects.requireNonNull(task, "task");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
        Objects.requireNonNull(next, "next");
    }

    /** What giving a task away would change; empty where it changes nothing. */
    public static Optional<TaskMovePreview> of(TaskId task, Optional<String> to, AllocationSnapshot now) {
        Optional<String> from = now.queues().entrySet().stream()
                .filter(queue -> queue.getValue().contains(task))
                .map(Map.Entry::getKey)
                .findFirst();
        if (from.equals(to)) {
            return Optional.empty();
        }
        List<TaskId> left = from.map(boat -> now.queues().get(boat)).orElse(List.of());
        boolean interrupts = !left.isEmpty() && left.get(0).equals(task);
        Optional<TaskId> next =
                left.stream().filter(other -> !other.equals(task)).findFirst();
        int place = to.map(boat -> now.queues().getOrDefault(boat, List.of()).size() + 1)
                .orElse(0);
        return Optional.of(new TaskMovePreview(task, from, to, place, interrupts, next));
    }

    /** In one sentence. */
    public String words() {
        String gains = to.map(
                        boat -> boat + " does " + task.name() + (place == 1 ? " at once" : " as its number " + place))
                .orElse("nobody does " + task.name());
        String loses = from.map(boat -> interrupts
                        ? "; " + boat + " leaves it now and "
                                + next.map(other -> "goes on with " + other.name())
                                        .orElse("has no task left")
                        : "; " + boat + " loses it")
                .orElse("");
        return gains + loses;
    }
}
