package org.sami.spn.sequence;

import java.util.List;
import java.util.Objects;

/**
 * A group of event types in a palette.
 *
 * @param id stable, by which a profile can hide the group
 * @param name for people
 * @param events names of event types, in order
 */
public record EventCategory(String id, String name, List<String> events) {
    public EventCategory {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        events = List.copyOf(events);
    }
}
