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
}
