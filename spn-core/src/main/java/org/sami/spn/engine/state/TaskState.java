package org.sami.spn.engine.state;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** A task of a running mission with its robot. A child's task that stands for one of its parent's shares the robot. */
public final class TaskState {
    public final TaskId id;
    public final String taskClass;
    public final Map<String, Value> fields;
    /** The parent's task that it stands for, or null. */
    public final @Nullable TaskState original;

    private String proxy = "";

    public TaskState(TaskId id, String taskClass, Map<String, Value> fields, @Nullable TaskState original) {
        this.id = id;
        this.taskClass = taskClass;
        this.fields = new LinkedHashMap<>(fields);
        this.original = original;
    }

    private TaskState(TaskState old, @Nullable TaskState original) {
        this.id = old.id;
        this.taskClass = old.taskClass;
        this.fields = old.fields;
        this.original = original;
        this.proxy = old.proxy;
    }

    /** The same task in the copy of a state; its fields never change. */
    TaskState copy(@Nullable TaskState original) {
        return new TaskState(this, original);
    }

    /** The robot it is allocated to, empty text where none. */
    public String proxy() {
        return original == null ? proxy : original.proxy();
    }

    /** The task itself: what this one stands for, or this one. */
    public TaskState owned() {
        return original == null ? this : original.owned();
    }

    public void allocate(String robot) {
        if (original == null) {
            proxy = robot;
        } else {
            original.allocate(robot);
        }
    }

    /** The value of a field: of the task that it stands for, else its own; null where neither has it. */
    public @Nullable Value field(String name) {
        Value value = original == null ? null : original.field(name);
        return value == null ? fields.get(name) : value;
    }
}
