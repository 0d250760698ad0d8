package org.sami.spn.component;

import java.util.ArrayList;
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

    /** These, and those of another domain whose names are not taken here. */
    public ComponentLibrary and(ComponentLibrary others) {
        List<ComponentType> all = new ArrayList<>(components);
        others.components.stream().filter(c -> component(c.name()).isEmpty()).forEach(all::add);
        List<WidgetType> allWidgets = new ArrayList<>(widgets);
        others.widgets.stream()
                .filter(w -> widgets.stream().noneMatch(own -> own.name().equals(w.name())))
                .forEach(allWidgets::add);
        return new ComponentLibrary(all, allWidgets);
    }

    /** The component of that name. */
    public Optional<ComponentType> component(String name) {
        return components.stream().filter(c -> c.name().equals(name)).findFirst();
    }
}
