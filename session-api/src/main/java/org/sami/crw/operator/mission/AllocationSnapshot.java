package org.sami.crw.operator.mission;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.value.TaskId;

/**
 * Who has which tasks, at a moment; tasks by the names of the missions that own them.
 *
 * @param queues the tasks of each boat, in the order in which it does them; the first is the one that it does now
 * @param unallocated tasks of running missions that no boat has and that are not complete, in order of creation
 */
public record AllocationSnapshot(Map<String, List<TaskId>> queues, List<TaskId> unallocated) {
    public static final AllocationSnapshot EMPTY = new AllocationSnapshot(Map.of(), List.of());

    public AllocationSnapshot {
        Map<String, List<TaskId>> copies = new LinkedHashMap<>();
        queues.forEach((boat, tasks) -> copies.put(boat, List.copyOf(tasks)));
        queues = Collections.unmodifiableMap(copies);
        unallocated = List.copyOf(unallocated);
    }
}
