package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.Value;

/** A task of a plan: its token is made when a mission starts. Names are unique in a mission. */
public record TaskSpec(String name, String taskClass, Map<String, Value> fields) {
    public TaskSpec {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(taskClass, "taskClass");
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
    }

    /** The same task with another name. */
    public TaskSpec withName(String name) {
        return new TaskSpec(name, taskClass, fields);
    }

    /** The same task with other fields. */
    public TaskSpec withFields(Map<String, Value> fields) {
        return new TaskSpec(name, taskClass, fields);
    }
}
