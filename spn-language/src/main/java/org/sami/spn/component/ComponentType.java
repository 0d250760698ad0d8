package org.sami.spn.component;

import java.util.List;
import java.util.Objects;

/**
 * A component that windows can make, such as a map or a list of boats (thesis 5.2.4, Components and widgets).
 *
 * @param name unique among the components of a domain; windows know it by this name
 * @param help a sentence for people
 * @param can what it does without any widget
 * @param widgets those that can be put on it (WC), in the order of the domain
 */
public record ComponentType(String name, String help, Capabilities can, List<WidgetType> widgets) {
    /** More would make the search for the fewest widgets long. */
    public static final int MOST_WIDGETS = 16;

    public ComponentType {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(help, "help");
        Objects.requireNonNull(can, "can");
        widgets = List.copyOf(widgets);
        if (widgets.size() > MOST_WIDGETS) {
            throw new IllegalArgumentException(name + " has " + widgets.size() + " widgets, more than " + MOST_WIDGETS);
        }
    }
}
