package org.sami.spn.vocabulary;

import java.util.List;
import java.util.Objects;

/** A class of tasks, such as Temperature or Camera, with the fields that every task of it has. */
public record TaskClass(String name, List<FieldType> fields, String help) {
    public TaskClass {
        Objects.requireNonNull(name, "name");
        fields = List.copyOf(fields);
        Objects.requireNonNull(help, "help");
    }
}
