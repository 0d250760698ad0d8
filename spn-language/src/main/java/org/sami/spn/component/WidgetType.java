package org.sami.spn.component;

import java.util.Objects;

/**
 * Something that can be put on a component and makes it able to do more, such as a layer of a map (thesis 5.2.4, Components and
 * widgets).
 *
 * @param name unique among the widgets of a domain
 * @param help a sentence for people
 */
public record WidgetType(String name, String help, Capabilities can) {
    public WidgetType {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(help, "help");
        Objects.requireNonNull(can, "can");
    }
}
