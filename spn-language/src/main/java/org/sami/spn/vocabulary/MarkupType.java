package org.sami.spn.vocabulary;

import java.util.List;
import java.util.Objects;

/**
 * A markup type of the domain (thesis appendix .2.3).
 *
 * @param options its options and parameters as fields; an enumeration where the thesis lists choices
 */
public record MarkupType(String name, List<String> aliases, List<FieldType> options, String label, String help) {
    public MarkupType {
        Objects.requireNonNull(name, "name");
        aliases = List.copyOf(aliases);
        options = List.copyOf(options);
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(help, "help");
    }
}
