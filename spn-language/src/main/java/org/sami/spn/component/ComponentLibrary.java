package org.sami.spn.component;

import java.util.List;
import java.util.Optional;

/**
 * The components that a domain's windows have.
 *
 * @param components in the order in which they are preferred, other things being equal
 * @param widgets all of them, also those of no component
 */
public record ComponentLibrary(List<ComponentType> components, List<WidgetType> widgets) {
    /** A domain without windows. */
    public static final ComponentLibrary EMPTY = new ComponentLibrary(List.of(), List.of());

    public ComponentLibrary {
        components = List.copyOf(components);
        widgets = List.copyOf(widgets);
    }

    /** The component of that name. */
    public Optional<ComponentType> component(String name) {
        return components.stream().filter(c -> c.name().equals(name)).findFirst();
    }
}
