package org.sami.dreamm.profile;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import java.util.Objects;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.JLabel;

/**
 * Takes from a panel what a profile hides, with its label, and keeps what it locks from being used; also what the panel adds later. A
 * component goes by the id that it was {@linkplain #mark given}, else by its name without numbers. On the event thread.
 */
public final class ProfileGuard {
    private static final String KEY = "sami.profile-id";

    private final Profile profile;
    private final Set<String> ids = ProfileIds.fixed();

    /** A guard of the panels of one window. */
    public ProfileGuard(Profile profile) {
        this.profile = Objects.requireNonNull(profile, "profile");
    }

    /** Gives a component the id by which profiles name it, where its name holds that of what it is about. */
    public static <C extends JComponent> C mark(C component, String id) {
        component.putClientProperty(KEY, id);
        return component;
    }

    /** The id by which profiles name a component; empty text where it has none. */
    public static String idOf(Component component) {
        if (component instanceof JComponent marked && marked.getClientProperty(KEY) instanceof String id) {
            return id;
        }
        String name = component.getName() == null ? "" : component.getName();
        return name.replaceAll("-[0-9]+(?=-|$)", "");
    }

    /** Guards a panel for as long as it is there. */
    public void guard(Component panel) {
        if (profile.isWhole()) {
            return;
        }
        String id = idOf(panel);
        if (ids.contains(id) && !profile.shows(id)) {
            remove(panel);
            return;
        }
        if (ids.contains(id)) {
            profile.whyLocked(id).ifPresent(why -> lock(panel, why));
        }
        if (panel instanceof Container container) {
            for (Component child : container.getComponents()) {
                guard(child);
            }
            container.addContainerListener(new ContainerAdapter() {
                @Override
                public void componentAdded(ContainerEvent e) {
                    guard(e.getChild());
                }
            });
        }
    }

    private static void remove(Component hidden) {
        Container parent = hidden.getParent();
        if (parent == null) {
            hidden.setVisible(false);
            return;
        }
        for (Component neighbour : parent.getComponents()) {
            if (neighbour instanceof JLabel label && hidden.equals(label.getLabelFor())) {
                parent.remove(label);
            }
        }
        parent.remove(hidden);
    }

    private static void lock(Component locked, String why) {
        locked.setEnabled(false);
        locked.addPropertyChangeListener("enabled", e -> {
            if (locked.isEnabled()) {
                locked.setEnabled(false);
            }
        });
        if (locked instanceof JComponent component) {
            component.setToolTipText(why);
        }
        if (locked instanceof Container container) {
            for (Component child : container.getComponents()) {
                lock(child, why);
            }
        }
    }
}
