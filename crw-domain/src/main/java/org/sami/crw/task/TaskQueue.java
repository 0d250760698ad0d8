package org.sami.crw.task;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * The tasks that one boat has to do, of all missions, in the order in which it does them (docs/language.md). The first is the one
 * that it does now. More urgent allocations come before less urgent ones; within one rank new tasks come last, and an allocation that
 * names tasks which the boat has already orders these among the places that they hold. Immutable.
 */
public final class TaskQueue {
    static final TaskQueue EMPTY = new TaskQueue(List.of());

    private final List<Entry> entries;

    private TaskQueue(List<Entry> entries) {
        this.entries = List.copyOf(entries);
    }

    /** One task and how urgent the allocation was that brought it. */
    private record Entry(TaskId task, Priority rank) {}

    /** The tasks in order. */
    public List<TaskId> tasks() {
        return entries.stream().map(Entry::task).toList();
    }

    /** The task that the boat does now. */
    public Optional<TaskId> current() {
        return entries.isEmpty() ? Optional.empty() : Optional.of(entries.get(0).task());
    }

    /** How many tasks are done before it; empty where the boat does not have it. */
    OptionalInt position(TaskId task) {
        int index = tasks().indexOf(task);
        return index < 0 ? OptionalInt.empty() : OptionalInt.of(index);
    }

    /** This queue after an allocation that gives the boat these tasks, in this order. */
    TaskQueue with(List<TaskId> named, Priority rank) {
        List<TaskId> inOrder = named.stream().distinct().toList();
        List<Entry> after = new ArrayList<>();
        int next = 0;
        for (Entry entry : entries) {
            after.add(inOrder.contains(entry.task()) ? new Entry(inOrder.get(next++), rank) : entry);
        }
        for (TaskId task : inOrder.subList(next, inOrder.size())) {
            after.add(new Entry(task, rank));
        }
        after.sort(Comparator.comparing(Entry::rank).reversed()); // stable: within a rank as it is
        return new TaskQueue(after);
    }

    /** This queue without a task. */
    TaskQueue without(TaskId task) {
        return new TaskQueue(
                entries.stream().filter(entry -> !entry.task().equals(task)).toList());
    }

    /** This queue without the tasks of a mission. */
    TaskQueue withoutMission(long mission) {
        return new TaskQueue(entries.stream()
                .filter(entry -> entry.task().mission() != mission)
                .toList());
    }

    /** As a value for the session's memory. */
    Value toValue() {
        Map<Value, Value> ranks = new LinkedHashMap<>();
        entries.forEach(
                entry -> ranks.put(entry.task(), new TextValue(entry.rank().name())));
        return new MapValue(ranks);
    }

    /** Reads what {@link #toValue} writes; anything else is an empty queue. */
    static TaskQueue of(Value value) {
        List<Entry> entries = new ArrayList<>();
        if (value instanceof MapValue map) {
            map.entries().forEach((task, rank) -> {
                if (task instanceof TaskId id && rank instanceof TextValue text) {
                    entries.add(new Entry(id, Priority.valueOf(text.value())));
                }
            });
        }
        return new TaskQueue(entries);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof TaskQueue queue && queue.entries.equals(entries);
    }

    @Override
    public int hashCode() {
        return entries.hashCode();
    }

    @Override
    public String toString() {
        return tasks().toString();
    }
}
