package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TaskId;

/** Which boat a task is allocated to: R-TASK-1. */
final class Allocating {
    private final World world;

    Allocating(World world) {
        this.world = world;
    }

    /** A released task loses its boat and nothing else (R-TASK-1). */
    void allocate(Map<TaskId, Optional<String>> allocation) {
        Map<TaskId, Optional<String>> robots = new LinkedHashMap<>();
        Map<TaskId, String> before = new LinkedHashMap<>();
        allocation.forEach((task, boat) -> {
            if (world.task(task).isEmpty()
                    || !world.proxies.containsAll(boat.stream().toList())) {
                world.note(
                        NoteKind.REJECTED_INPUT,
                        world.mission(task.mission()).map(m -> m.id).orElse(0L),
                        task.name());
                return;
            }
            TaskId owned = world.owned(task);
            if (!before.containsKey(owned) && !robots.containsKey(owned)) {
                world.boatOf(owned).ifPresent(had -> before.put(owned, had));
            }
            world.allocation.remove(owned);
            boat.ifPresent(has -> world.allocation.put(owned, has));
            robots.put(owned, boat);
        });
        tell(robots, before);
    }

    /** A dropped boat: its tasks lose it. */
    void release(Mission m, String boat) {
        List<TaskId> released = new ArrayList<>();
        for (TaskSpec task : m.tasks.values()) {
            TaskId id = new TaskId(m.id, task.name());
            if (world.owned(id).equals(id) && world.boatOf(id).equals(Optional.of(boat))) {
                released.add(id);
            }
        }
        Map<TaskId, Optional<String>> robots = new LinkedHashMap<>();
        Map<TaskId, String> before = new LinkedHashMap<>();
        for (TaskId id : released) {
            world.allocation.remove(id);
            robots.put(id, Optional.empty());
            before.put(id, boat);
        }
        tell(robots, before);
    }

    private void tell(Map<TaskId, Optional<String>> robots, Map<TaskId, String> before) {
        if (!robots.isEmpty()) {
            world.effects.add(new Effect.TasksAllocated(robots, before, Priority.MEDIUM));
        }
    }
}
