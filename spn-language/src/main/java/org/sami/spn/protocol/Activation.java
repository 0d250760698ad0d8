package org.sami.spn.protocol;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * One output event sent for one visit, with everything that its handler needs; immutable (R-ACT-1).
 *
 * @param rootMission the root of the mission tree that the mission is in
 * @param event id of the output event specification in the plan
 * @param values resolved values of the fields, without those that are read per task
 * @param taskValues values of the fields with source {@code @task}, by entering task
 * @param tokens the tokens that entered, in order; empty for an entry by nobody
 * @param allocation the proxy of each entering task that has one, at entry
 */
public record Activation(
        long id,
        long mission,
        long rootMission,
        long visit,
        String plan,
        String place,
        String event,
        String type,
        Map<String, Value> values,
        Map<TaskId, Map<String, Value>> taskValues,
        List<Token> tokens,
        Map<TaskId, String> allocation,
        List<MarkupSpec> markups,
        Priority priority) {
    public Activation {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(event, "event");
        Objects.requireNonNull(type, "type");
        values = values.isEmpty() ? Map.of() : Collections.unmodifiableMap(new LinkedHashMap<>(values));
        taskValues = taskValues.isEmpty() ? Map.of() : Collections.unmodifiableMap(new LinkedHashMap<>(taskValues));
        tokens = List.copyOf(tokens);
        allocation = allocation.isEmpty() ? Map.of() : Collections.unmodifiableMap(new LinkedHashMap<>(allocation));
        markups = List.copyOf(markups);
        Objects.requireNonNull(priority, "priority");
    }

    /** The value of a field, empty where it has none. */
    public Optional<Value> value(String field) {
        return Optional.ofNullable(values.get(field));
    }

    /** The robots that entered: of proxy tokens, and of task tokens that are allocated; each once, in order of entry. */
    public List<String> proxies() {
        return tokens.stream()
                .map(this::proxyOf)
                .flatMap(Optional::stream)
                .distinct()
                .toList();
    }

    /** The tasks that entered, each once, in order of entry. */
    public List<TaskId> tasks() {
        return tokens.stream()
                .filter(Token.Task.class::isInstance)
                .map(t -> ((Token.Task) t).task())
                .distinct()
                .toList();
    }

    private Optional<String> proxyOf(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return Optional.of(proxy.proxy());
        }
        if (token instanceof Token.Task task) {
            return Optional.ofNullable(allocation.get(task.task()));
        }
        return Optional.empty();
    }
}
