package org.sami.spn.protocol;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * One input event received.
 *
 * <p>Implements R-OCC-1.
 *
 * @param type name of the input event type
 * @param mission the mission that it is for, or {@link Ids#NONE} for news to all
 * @param activation the activation that it answers, or {@link Ids#NONE}
 * @param proxies the robots that it names (the thesis's relevant proxies)
 * @param tasks the tasks that it names
 * @param values by the names of the event's fields, in the order of the names: its text is the same in every process, and so are hashes of runs
 */
public record Occurrence(
        String type,
        long mission,
        long activation,
        List<String> proxies,
        List<TaskId> tasks,
        Map<String, Value> values) {
    public Occurrence {
        Objects.requireNonNull(type, "type");
        proxies = List.copyOf(proxies);
        tasks = List.copyOf(tasks);
        values = values.isEmpty() ? Map.of() : Collections.unmodifiableMap(new TreeMap<>(values));
    }

    /** News to all missions. */
    public static Occurrence news(String type, List<String> proxies, Map<String, Value> values) {
        return new Occurrence(type, Ids.NONE, Ids.NONE, proxies, List.of(), values);
    }

    /** An answer to an activation. */
    public static Occurrence answer(
            String type, Activation activation, List<String> proxies, List<TaskId> tasks, Map<String, Value> values) {
        return new Occurrence(type, activation.mission(), activation.id(), proxies, tasks, values);
    }

    /** Whether it names at least one robot or task. */
    public boolean namesSomebody() {
        return !proxies.isEmpty() || !tasks.isEmpty();
    }
}
