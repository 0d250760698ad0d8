package org.sami.spn.vocabulary;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * An event type of the domain (thesis appendix .2).
 *
 * @param name the appendix's name without spaces, such as {@code ProxyExecutePath}
 * @param aliases other names under which plans may speak of it
 * @param fields in order
 * @param answers for output events: the input events that can answer it
 * @param decision for output events that ask the operator
 * @param label for people, such as "Proxy Execute Path"
 * @param help a sentence for the plan's author
 */
public record EventType(
        String name,
        List<String> aliases,
        Direction direction,
        List<FieldType> fields,
        TokenNeed tokens,
        List<String> answers,
        EventRole role,
        Set<EventFlag> flags,
        Optional<DecisionType> decision,
        String label,
        String help) {
    public EventType {
        Objects.requireNonNull(name, "name");
        aliases = List.copyOf(aliases);
        Objects.requireNonNull(direction, "direction");
        fields = List.copyOf(fields);
        Objects.requireNonNull(tokens, "tokens");
        answers = List.copyOf(answers);
        Objects.requireNonNull(role, "role");
        flags = Set.copyOf(flags);
        Objects.requireNonNull(decision, "decision");
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(help, "help");
    }

    /** What people call it: its label, or its name where it has none. */
    public String title() {
        return label.isBlank() ? name : label;
    }

    /** The field of that name, empty where the event has none. */
    public Optional<FieldType> field(String field) {
        return fields.stream().filter(f -> f.name().equals(field)).findFirst();
    }
}
