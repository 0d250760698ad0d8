package org.sami.spn.value;

import java.util.Objects;

/**
 * The identity of one task of one mission, as a value and everywhere else.
 *
 * @param mission the mission that owns the task: a task token never changes its owner
 */
public record TaskId(long mission, String name) implements Value {
    public TaskId {
        Objects.requireNonNull(name, "name");
    }
}
