package org.sami.dreamm.inspector;

import java.awt.Component;
import java.awt.Container;
import javax.swing.JComponent;

/** What was typed and not given yet: a component that holds such a thing says how it is given. */
final class Pending {
    /** The client property of a component that holds a {@link Runnable}. */
    static final String KEY = "sami.pending";

    private Pending() {}

    /** Gives what is held below a component, before that goes. */
    static void give(Container root) {
        for (Component child : root.getComponents()) {
            if (child instanceof JComponent component && component.getClientProperty(KEY) instanceof Runnable give) {
                give.run();
            }
            if (child instanceof Container inner) {
                give(inner);
            }
        }
    }
}
