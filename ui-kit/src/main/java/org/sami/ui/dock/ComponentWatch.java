package org.sami.ui.dock;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import java.util.Arrays;
import java.util.function.Consumer;

/** Finds the components that Modern Docking lays panels into, those of later too; it does not look into panels. On the event thread. */
final class ComponentWatch extends ContainerAdapter {
    private final Consumer<Component> found;

    private ComponentWatch(Consumer<Component> found) {
        this.found = found;
    }

    /**
     * Tells each component below one, and that one, once; each that is added later as it is added.
     *
     * @param found receives it
     */
    static void on(Component component, Consumer<Component> found) {
        new ComponentWatch(found).look(component);
    }

    private void look(Component component) {
        if (component instanceof DockPanel || !(component instanceof Container container)) {
            return;
        }
        found.accept(component);
        container.addContainerListener(this);
        for (Component child : container.getComponents()) {
            lookOnce(child);
        }
    }

    @Override
    public void componentAdded(ContainerEvent added) {
        lookOnce(added.getChild());
    }

    /** Modern Docking takes components out and puts them in again as it docks. */
    private void lookOnce(Component child) {
        boolean known = child instanceof Container container
                && Arrays.asList(container.getContainerListeners()).contains(this);
        if (!known) {
            look(child);
        }
    }
}
