package org.sami.crw.event;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Who visits what, and in which order: one option of the event Operator Allocation Options (appendix .2.1).
 *
 * @param paths the locations of each boat in the order of its visits, without its present position; a boat that has
 *     nothing to visit has an empty path
 * @param totalLengthM sum of the lengths of all paths, each from its boat's position at the time of the allocation
 * @param longestM length of the longest path, measured likewise
 * @param method how it was found, for people
 * @param reason why that method was chosen, for people
 * @param unallocated what nobody got and why, for people, a sentence each
 * @param tasks the boat of each task, where tasks were allocated and not mere locations
 */
public record Allocation(
        Map<String, GeoPath> paths,
        double totalLengthM,
        double longestM,
        String method,
        String reason,
        List<String> unallocated,
        Map<TaskId, String> tasks) {
    /** Name of the record type in the vocabulary. */
    public static final String TYPE = "Allocation";

    public Allocation {
        paths = Collections.unmodifiableMap(new LinkedHashMap<>(paths));
        Objects.requireNonNull(method, "method");
        Objects.requireNonNull(reason, "reason");
        unallocated = List.copyOf(unallocated);
        tasks = Collections.unmodifiableMap(new LinkedHashMap<>(tasks));
    }

    /** An allocation of locations in which everything was allocated. */
    public Allocation(Map<String, GeoPath> paths, double totalLengthM, double longestM, String method) {
        this(paths, totalLengthM, longestM, method, "", List.of(), Map.of());
    }

    /** The same with the reason for its method. */
    public Allocation withReason(String why) {
        return new Allocation(paths, totalLengthM, longestM, method, why, unallocated, tasks);
    }

    /** The same with what nobody got. */
    public Allocation withUnallocated(List<String> sentences) {
        return new Allocation(paths, totalLengthM, longestM, method, reason, sentences, tasks);
    }

    /** The same with the boat of each task. */
    public Allocation withTasks(Map<TaskId, String> boatOf) {
        return new Allocation(paths, totalLengthM, longestM, method, reason, unallocated, boatOf);
    }

    /** This allocation as a value of the vocabulary's type {@link #TYPE}. */
    public RecordValue toValue() {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("paths", ProxyMaps.toValue(paths));
        fields.put("totalLengthM", new RealValue(totalLengthM));
        fields.put("longestM", new RealValue(longestM));
        fields.put("method", new TextValue(method));
        fields.put("reason", new TextValue(reason));
        fields.put(
                "unallocated",
                new ListValue(unallocated.stream().<Value>map(TextValue::new).toList()));
        Map<Value, Value> boatOf = new LinkedHashMap<>();
        tasks.forEach((task, boat) -> boatOf.put(task, new ProxyValue(boat)));
        fields.put("tasks", new MapValue(boatOf));
        return new RecordValue(TYPE, fields);
    }

    /**
     * Reads what {@link #toValue} writes.
     *
     * @throws IllegalArgumentException for a value of another type
     */
    public static Allocation of(Value value) {
        if (!(value instanceof RecordValue fields) || !fields.type().equals(TYPE)) {
            throw new IllegalArgumentException("Not an allocation: " + value);
        }
        Map<String, GeoPath> paths = ProxyMaps.read(required(fields, "paths"), GeoPath.class);
        List<String> unallocated = ((ListValue) required(fields, "unallocated"))
                .items().stream().map(item -> ((TextValue) item).value()).toList();
        Map<TaskId, String> tasks = new LinkedHashMap<>();
        ((MapValue) required(fields, "tasks"))
                .entries()
                .forEach((task, boat) -> tasks.put((TaskId) task, ((ProxyValue) boat).proxy()));
        return new Allocation(
                paths,
                Numbers.real(required(fields, "totalLengthM")),
                Numbers.real(required(fields, "longestM")),
                text(fields, "method"),
                text(fields, "reason"),
                unallocated,
                tasks);
    }

    private static String text(RecordValue fields, String name) {
        return ((TextValue) required(fields, name)).value();
    }

    private static Value required(RecordValue fields, String name) {
        return fields.field(name)
                .orElseThrow(() -> new IllegalArgumentException("An allocation without \"" + name + "\""));
    }
}
